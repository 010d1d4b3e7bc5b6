// Draws the plots of the page with plotly.js; the program has computed all numbers and sentences. The element #plots
// contains for each case "plots" (figures of plotly.js; "@name" refers to a shared array), "maps" (joint densities),
// "errors" (error sources of moments), and "slider" (plots at each position of a slider). Plots in a closed <details> element are drawn when the element opens. The
// attribute <html data-plots="drawn"> states that all visible plots are drawn.
'use strict';

const narrow = () => window.innerWidth < 600;
const onPaper = () => document.body.classList.contains('on-paper');

// The light and dark colours of page.css; a printed page always has the light colours.
const light = {ink: '#222222', paper: '#ffffff', grid: '#e4e4e4', zero: '#b0b0b0', line: '#555555', nothing: '#d9d9d9',
               band: 'rgba(0,0,0,0.18)'};
const dark = {ink: '#dddddd', paper: '#15181c', grid: '#2f353d', zero: '#606770', line: '#9aa0a8', nothing: '#3a4048',
              band: 'rgba(255,255,255,0.22)'};
const wantsDark = window.matchMedia('(prefers-color-scheme: dark)');
const theme = () => wantsDark.matches && !onPaper() ? dark : light;

// Adapts a colour to the theme: on a dark page a dark colour is mixed with white.
function seen(colour) {
  const parts = /^#(..)(..)(..)$/.exec(colour);
  if (!parts || theme() === light) return colour;
  const rgb = parts.slice(1).map(part => parseInt(part, 16));
  const luminance = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  const least = 150;
  if (luminance >= least) return colour;
  const share = (least - luminance) / (255 - luminance);
  return '#' + rgb.map(c => Math.round(c + share * (255 - c)).toString(16).padStart(2, '0')).join('');
}

// Adapts all colours in a trace or a layout.
function themed(value) {
  if (typeof value === 'string') return value === light.band ? theme().band : seen(value);
  if (Array.isArray(value)) return value.map(themed);
  if (value === null || typeof value !== 'object' || 'bdata' in value) return value;
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, themed(one)]));
}

const font = () => ({family: 'system-ui, "Segoe UI", Roboto, Helvetica, Arial, sans-serif', size: 12, color: theme().ink});
const axis = () => ({gridcolor: theme().grid, zerolinecolor: theme().zero, linecolor: theme().line, ticks: 'outside',
                     ticklen: 4, showline: true, automargin: true});
// The page sends no data: plotly.js gets neither an upload button nor a server address.
const config = () => ({displaylogo: false, displayModeBar: narrow() ? false : 'hover', plotlyServerURL: '',
                       modeBarButtons: [['toImage', 'zoom2d', 'pan2d', 'zoomIn2d', 'zoomOut2d', 'resetScale2d']]});

// A printed page omits hidden traces, since its reader cannot make them visible.
const isLeftOut = trace => onPaper() && trace.visible === 'legendonly';

// Height of the legend below the plot, from its number of lines.
function legendHeight(figure, width) {
  let lines = 1, used = 0;
  for (const trace of figure.data) {
    if (trace.showlegend === false || isLeftOut(trace)) continue;
    const entry = 6.3 * trace.name.length + 52;
    if (used > 0 && used + entry > width) {
      lines += 1;
      used = 0;
    }
    used += entry;
  }
  return 19 * lines + 14;
}

function sizeOf(div, figure) {
  const width = div.clientWidth, legend = legendHeight(figure, width);
  // A printed page has two plots side by side, each half as wide as on a screen.
  return {width, height: (onPaper() ? 0.6 : 1) * figure.height + legend, bottom: 50 + legend};
}

function layoutOf(figure, size) {
  const layout = {
    font: font(), paper_bgcolor: theme().paper, plot_bgcolor: theme().paper, hovermode: narrow() ? 'closest' : 'x unified',
    // On a phone a finger scrolls the page.
    dragmode: narrow() ? false : 'zoom',
    hoverlabel: {font: {size: 11, color: theme().ink}, bgcolor: theme().paper, namelength: -1},
    showlegend: true,
    legend: {orientation: 'h', x: 0, xanchor: 'left', xref: 'container', y: 0, yref: 'container', yanchor: 'bottom',
             font: {size: 11}, tracegroupgap: 0},
    width: size.width, height: size.height, margin: {l: 64, r: 14, t: 32, b: size.bottom},
    ...themed(figure.layout),
  };
  for (const key of Object.keys(layout).filter(key => /^[xy]axis/.test(key))) {
    // plotly.js enlarges powers of ten by a quarter.
    const tickfont = layout[key].type === 'log' ? {tickfont: {size: font().size / 1.25}} : {};
    layout[key] = {...axis(), ...tickfont, ...layout[key], title: {standoff: 6, ...layout[key].title}};
  }
  return layout;
}

function withArrays(trace, arrays) {
  const resolved = value => typeof value === 'string' && value.startsWith('@') ? arrays[value.slice(1)] : value;
  return {...themed(trace), x: resolved(trace.x), y: resolved(trace.y)};
}

// Applies the visibility of the solutions in a changed plot to all plots of its case.
function followLegend(changed, divs) {
  const visible = new Map(changed.data.map(trace => [trace.legendgroup, trace.visible ?? true]));
  for (const div of divs) {
    if (div === changed || !div.data) continue;
    const indices = [], values = [];
    div.data.forEach((trace, index) => {
      const wanted = visible.get(trace.legendgroup);
      if (wanted === undefined || wanted === (trace.visible ?? true)) return;
      indices.push(index);
      values.push(wanted);
    });
    if (indices.length) Plotly.restyle(div, {visible: values}, indices);
  }
}

// Returns the plots of a group: first the plots at the position of the slider, then the plots without a slider.
const plotsOf = ({slider, plots}) =>
  slider ? [...slider.steps[document.getElementById(slider.id).value], ...plots] : plots;

// Shows the plots, the label and the table at the position of a slider.
function followSlider(slider, plots) {
  const input = document.getElementById(slider.id);
  const showTexts = () => {
    const label = slider.labels[input.value];
    document.getElementById(`${slider.id}-label`).textContent = label;
    input.setAttribute('aria-valuetext', label);
    document.querySelectorAll(`[data-slider="${slider.id}"]`).forEach((part, k) => { part.hidden = k !== Number(input.value); });
  };
  input.addEventListener('input', () => {
    showTexts();
    for (const plot of plots.slice(0, slider.steps[0].length)) plot.draw();
  });
  showTexts();
}

// Returns the plots and maps of a case as objects: the HTML element, fit(), which sets the size of the element, and
// draw(). Callers may call fit() and draw() repeatedly.
function drawables(one) {
  const divs = plotsOf(one).map(plot => document.getElementById(plot.id));
  const plots = divs.map((div, index) => {
    const fit = () => { div.style.height = `${sizeOf(div, plotsOf(one)[index].figure).height}px`; };
    const draw = () => {
      const figure = plotsOf(one)[index].figure, first = !div.data;
      // Traces keep the visibility that the reader of the page chose.
      const data = figure.data.map((trace, k) => ({...withArrays(trace, figure.arrays),
                                                   ...(first ? {} : {visible: div.data[k].visible})}))
                              .map(trace => isLeftOut(trace) ? {...trace, showlegend: false} : trace);
      // The axes keep the ranges to which the reader of the page zoomed.
      Plotly.react(div, data, {...layoutOf(figure, sizeOf(div, figure)), uirevision: one.slider?.id}, config());
      if (first) div.on('plotly_restyle', () => followLegend(div, divs));
    };
    return {element: div, fit, draw};
  });
  if (one.slider) followSlider(one.slider, plots);
  return [...plots, ...(one.maps ? mapDrawables(one.maps) : []), ...(one.errors ? choiceDrawables(one.errors) : [])];
}

const bytesOf = base64 => Uint8Array.from(atob(base64), c => c.charCodeAt(0));
const numbers = array => new Float32Array(bytesOf(array.bdata).buffer);

// Unpacks signed roots (report/figure/heat_map_values.hpp): the roots from -1 to 1, then the values.
function roots({steps, levels}) {
  let sum = 0;
  return Float64Array.from(steps, step => (sum += step) / levels);
}
const signedNumbers = packed => roots(packed).map(q => Math.sign(q) * q * q * packed.largest);

// The values as rows, the input of heat maps.
function rows(values, length) {
  const result = [];
  for (let k = 0; k < values.length; k += length) result.push(Array.from(values.slice(k, k + length)));
  return result;
}

const ends = edges => [edges[0], edges.at(-1)];

// Height of a heat map with square axes, at most 440 pixels in total.
const mapHeight = div => Math.min(440, Math.round(div.clientWidth - 64) + 142);

// Draws a heat map over the cells between the edges y and v.
// @param told: the values in the hover label, if different from the drawn values
function drawMap(div, y, v, values, {colours, title, ticks, ranges, told = values, name = title}) {
  const trace = {
    type: 'heatmap', x: y, y: v, z: rows(values, y.length - 1), customdata: rows(told, y.length - 1), ...colours,
    colorbar: {orientation: 'h', y: -0.16, yanchor: 'top', thickness: 12, len: 1, tickfont: {size: 10},
               exponentformat: 'power', ...ticks},
    hovertemplate: `y = %{x:.3f}, y′ = %{y:.3f}<br>${name}: %{customdata:.2g}<extra></extra>`,
  };
  const layout = {
    font: font(), paper_bgcolor: theme().paper, plot_bgcolor: theme().nothing, width: div.clientWidth, height: mapHeight(div),
    margin: {l: 50, r: 14, t: 32, b: 110},
    // An annotation replaces the title of the colour bar, which would overlap the tics.
    annotations: [{text: title, showarrow: false, xref: 'paper', x: 0.5, yref: 'paper', y: -110 / (mapHeight(div) - 142),
                   yanchor: 'bottom'}],
    dragmode: narrow() ? false : 'zoom', showlegend: false,
    xaxis: {...axis(), showgrid: false, range: ranges[0], title: {text: 'y', standoff: 4}},
    yaxis: {...axis(), showgrid: false, range: ranges[1], title: {text: 'y′', standoff: 4}},
  };
  Plotly.react(div, [trace], layout, config());
}

function mapDrawables(maps) {
  const part = name => document.getElementById(`${maps.id}-${name}`);
  const y = Array.from(numbers(maps.y_edges)), v = Array.from(numbers(maps.v_edges));
  const reference = numbers(maps.density);
  const peak = reference.reduce((a, b) => Math.max(a, b), 0);

  const log10 = p => p > 0 ? Math.log10(p) : null;
  const chosen = () => maps.differences[part('choice').selectedIndex];
  const logarithmic = () => part('scale').value === 'logarithmic';

  function draw(name, values, colours, title) {
    const log = logarithmic();
    drawMap(part(name), y, v, values, {
      colours, title, ticks: log ? {dtick: name === 'difference' ? 0.5 : 1} : {nticks: 5},
      ranges: log ? [ends(y), ends(v)] : [maps.y_bulk, maps.v_bulk]});
  }

  function drawAll() {
    const difference = signedNumbers(chosen());
    // A density below the rounding error of the difference is taken as 0: the simulation has no samples in that cell.
    const rounding = d => 1.01 * Math.sqrt(Math.abs(d) * chosen().largest) / chosen().levels;
    const density = reference.map((p, k) => p + difference[k] > rounding(difference[k]) ? p + difference[k] : 0);
    const log = logarithmic();
    const shown = values => log ? Array.from(values, log10) : Array.from(values);
    const sequential = {colorscale: 'Viridis', zmin: log ? Math.log10(peak) - maps.decades : 0, zmax: log ? Math.log10(peak) : peak};
    const title = log ? 'log<sub>10</sub> p' : 'p';
    draw('reference', shown(reference), sequential, title);
    draw('chosen', shown(density), sequential, title);
    const ratio = Array.from(density, (p, k) => p > 0 && reference[k] > 0 ? Math.log10(p / reference[k]) : null);
    const limit = log ? 1 : chosen().largest || 1;
    draw('difference', log ? ratio : Array.from(difference), {colorscale: maps.colours, zmin: -limit, zmax: limit},
         log ? 'log<sub>10</sub> of the ratio' : 'difference');
    const name = chosen().solution;
    part('name').textContent = name;
    part('caption').textContent = log ? `${name} / ${maps.reference}, colours up to a factor of 10; grey: no density` : `${name} − ${maps.reference}`;
  }

  part('choice').addEventListener('change', drawAll);
  part('scale').addEventListener('change', drawAll);
  const fit = () => { for (const name of ['reference', 'chosen', 'difference']) part(name).style.height = `${mapHeight(part(name))}px`; };
  return [{element: part('reference'), fit, draw: drawAll}];
}

// The heat maps of a figure (report/page/heat_maps.hpp); a control selects the drawn maps.
function choiceDrawables({control, choices}) {
  const select = document.getElementById(control);
  const maps = () => choices[select.selectedIndex];
  const place = map => document.getElementById(map.id);
  const edges = ([from, to], cells) => Array.from({length: cells + 1}, (_, k) => from + (to - from) * k / cells);
  const drawAll = () => maps().forEach(map => {
    drawMap(place(map), edges(map.x, map.columns), edges(map.y, map.steps.length / map.columns), Array.from(roots(map)), {
      colours: {colorscale: map.colours, zmin: -1, zmax: 1}, title: map.title, ranges: [map.x, map.y],
      ticks: {tickvals: map.tickvals, ticktext: map.ticktext}, told: signedNumbers(map), name: map.quantity});
    place(map).parentElement.querySelector('figcaption').textContent = map.caption;
    place(map).setAttribute('aria-label', map.spoken);
  });
  select.addEventListener('change', drawAll);
  const fit = () => { for (const map of maps()) place(map).style.height = `${mapHeight(place(map))}px`; };
  return [{element: place(maps()[0]), fit, draw: drawAll}];
}

let all = [], waiting = [];
// The test uses the ancestors, since browsers differ in the width of elements within a closed <details>.
const isSeen = one => one.element.closest('details:not([open])') === null;

// Draws the plots one after another: the page remains responsive.
function drawNext() {
  const next = waiting.shift();
  if (next) {
    if (isSeen(next)) {
      next.fit();
      next.draw();
    }
    setTimeout(drawNext);
  } else {
    document.documentElement.dataset.plots = 'drawn';
  }
}

function draw(some) {
  delete document.documentElement.dataset.plots;
  const idle = waiting.length === 0;
  waiting.push(...some);
  if (idle) drawNext();
}

function redraw() {
  waiting.length = 0;
  for (const one of all.filter(isSeen)) {
    one.fit();
    one.draw();
  }
}

// Opens the <details> elements around the target of a link.
function reveal() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  for (let e = target; e; e = e.parentElement) if (e.tagName === 'DETAILS') e.open = true;
  if (target) target.scrollIntoView();
}

async function unpacked(id) {
  const stream = new Blob([bytesOf(document.getElementById(id).textContent)]).stream();
  return new Response(stream.pipeThrough(new DecompressionStream('gzip'))).text();
}

async function begin() {
  const library = document.createElement('script');
  library.textContent = await unpacked('plotly');
  document.head.append(library);
  const cases = JSON.parse(await unpacked('plots'));
  all = cases.flatMap(drawables);
  for (const one of all.filter(isSeen)) one.fit();
  for (const details of document.querySelectorAll('.case details')) {
    details.addEventListener('toggle', () => {
      if (details.open) draw(all.filter(one => details.contains(one.element)));
    });
  }
  draw(all.filter(isSeen));
  if (location.hash) reveal();
}

if (typeof DecompressionStream === 'undefined') {
  document.querySelector('main').insertAdjacentHTML('afterbegin', '<p>The plots need a browser of 2023 or later; the tables do not.</p>');
} else {
  begin();
}

window.addEventListener('hashchange', reveal);
for (const menu of document.querySelectorAll('.menu')) {
  menu.addEventListener('click', event => { if (event.target.tagName === 'A') menu.open = false; });
  document.addEventListener('click', event => { if (!menu.contains(event.target)) menu.open = false; });
}
wantsDark.addEventListener('change', redraw);

let resized, lastWidth = window.innerWidth;
window.addEventListener('resize', () => {
  // Only a new width requires new plots: on a phone, scrolling changes the height.
  if (window.innerWidth === lastWidth) return;
  lastWidth = window.innerWidth;
  clearTimeout(resized);
  resized = setTimeout(redraw, 150);
});

// The page has a fixed width on paper (page.css).
window.addEventListener('beforeprint', () => {
  document.body.classList.add('on-paper');
  redraw();
});
window.addEventListener('afterprint', () => {
  document.body.classList.remove('on-paper');
  redraw();
});
