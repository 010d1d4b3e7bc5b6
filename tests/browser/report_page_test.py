#!/usr/bin/env python3
"""Opens report.html of a run in headless Chromium and tests its contents and behaviour.

usage: report_page_test.py DIR      DIR: directory of `fpkcheck run --out DIR`

Exit code 77 (skipped) when Chromium, its driver or Selenium is not installed.
"""
import csv
import json
import pathlib
import shutil
import sys
import time
import unittest

SKIPPED = 77
LACKING = 'Debian: apt-get install chromium chromium-driver python3-selenium'
try:
    from selenium import webdriver
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    print(f'skipped: Selenium is not installed ({LACKING})')
    sys.exit(SKIPPED)

CHROMIUM, DRIVER = shutil.which('chromium'), shutil.which('chromedriver')
if not CHROMIUM or not DRIVER:
    print(f'skipped: no chromium or chromedriver on the PATH ({LACKING})')
    sys.exit(SKIPPED)

DESKTOP, PHONE = (1280, 900), (390, 844)
# The page stores numbers as 32-bit floating point.
RELATIVE_ROUNDING = 6e-8
DIRECTORY = None  # set by main


def open_browser():
    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    for argument in ('--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage',
                     f'--window-size={DESKTOP[0]},{DESKTOP[1]}'):
        options.add_argument(argument)
    options.set_capability('goog:loggingPrefs', {'browser': 'ALL', 'performance': 'ALL'})
    service = webdriver.chrome.service.Service(DRIVER)
    return webdriver.Chrome(service=service, options=options)


class ReportPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = open_browser()
        cls.summary = json.loads((DIRECTORY / 'summary.json').read_text())
        cls.address = (DIRECTORY / 'report.html').resolve().as_uri()
        cls.browser.execute_cdp_cmd('Network.enable', {})
        cls.browser.execute_cdp_cmd('Network.emulateNetworkConditions', {
            'offline': True, 'latency': 0, 'downloadThroughput': 0, 'uploadThroughput': 0})
        cls.open_page()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()

    @classmethod
    def open_page(cls, size=DESKTOP):
        cls.browser.execute_cdp_cmd('Emulation.setDeviceMetricsOverride', {
            'width': size[0], 'height': size[1], 'deviceScaleFactor': 1, 'mobile': size == PHONE})
        cls.browser.get(cls.address)
        cls.wait_until_drawn()
        folded = cls.script('return [...document.querySelectorAll(".case details:not([open]) .plot")].map('
                            'plot => plot.innerHTML).join("")')
        assert folded == '', 'plots in closed sections must not be drawn before they are opened'
        cls.script('document.querySelectorAll(".case details").forEach(details => { details.open = true; })')
        time.sleep(0.1)  # until the toggle events are dispatched
        cls.wait_until_drawn()

    @classmethod
    def wait_until_drawn(cls):
        WebDriverWait(cls.browser, 60).until(
            lambda browser: cls.script('return document.documentElement.dataset.plots') == 'drawn')

    @classmethod
    def script(cls, code, *arguments):
        return cls.browser.execute_script(code, *arguments)

    def traces(self, plot):
        """Name, group, axis, visibility and numbers of each trace of a plot."""
        return self.script('''
            const plot = document.getElementById(arguments[0]);
            return plot._fullData.map(t => ({name: t.name, group: t.legendgroup, axis: t.yaxis, visible: t.visible,
                                             skip: t.hoverinfo === 'skip',
                                             x: Array.from(t.x || []), y: Array.from(t.y || [])}));''', plot)

    def curves(self, plot, axis):
        return {t['group']: t for t in self.traces(plot) if t['axis'] == axis and not t['skip']}

    def marginals(self, name='marginals.csv'):
        """{(case, variable, solution): (abscissa, density, half-width of the interval)}"""
        found = {}
        with open(DIRECTORY / name, newline='') as file:
            for row in csv.DictReader(file):
                key = (row['case'], row['variable'], row['solution'])
                abscissa, density, half_width = found.setdefault(key, ([], [], []))
                abscissa.append(float(row['abscissa']))
                density.append(float(row['density']))
                half_width.append((float(row['upper'] or 0) - float(row['lower'] or 0)) / 2)
        return found

    def assert_close(self, found, expected, what, slack=0.0):
        self.assertEqual(len(found), len(expected), what)
        for a, b in zip(found, expected):
            self.assertLessEqual(abs(a - b), RELATIVE_ROUNDING * abs(b) + slack, what)

    def test_1_loads_without_console_messages(self):
        self.assertEqual(self.browser.get_log('browser'), [])

    def test_2_requests_no_other_resources(self):
        self.assertEqual(self.script('return performance.getEntriesByType("resource").map(e => e.name)'), [])
        requests = []
        for entry in self.browser.get_log('performance'):
            message = json.loads(entry['message'])['message']
            if message['method'] == 'Network.requestWillBeSent':
                requests.append(message['params']['request']['url'])
        elsewhere = [url for url in requests if url != self.address and not url.startswith(('data:', 'blob:'))]
        self.assertEqual(elsewhere, [])
        links = self.script('return [...document.querySelectorAll("[href], [src]")].map('
                            'e => e.getAttribute("href") || e.getAttribute("src"))')
        self.assertEqual([link for link in links if not link.startswith(('#', 'data:'))], [])

    def test_3_has_all_curves_with_their_numbers(self):
        marginals, smooth = self.marginals(), self.marginals('smooth.csv')
        self.assertTrue(marginals)
        for number, one in enumerate(self.summary['cases'], 1):
            for variable in ('y', 'ydot'):
                expected = {solution: curve for (name, v, solution), curve in marginals.items()
                            if name == one['name'] and v == variable}
                plot = f'case-{number}-density-{variable}'
                for axis in ('y', 'y2'):
                    curves = self.curves(plot, axis)
                    self.assertEqual(set(curves), set(expected), f'{plot} {axis}')
                    for solution, (abscissa, density, _) in expected.items():
                        self.assert_close(curves[solution]['x'], abscissa, (plot, axis, solution))
                        self.assert_close(curves[solution]['y'], density, (plot, axis, solution))
                differences = self.curves(plot, 'y3')
                self.assertEqual(set(differences), set(expected))
                _, reference, half_width = smooth[one['name'], variable, one['reference']]
                for solution in expected:
                    abscissa, density, _ = smooth[one['name'], variable, solution]
                    size = half_width if solution == one['reference'] else [
                        abs(p - q) for p, q in zip(density, reference)]
                    self.assert_close(differences[solution]['x'], abscissa, (plot, solution))
                    self.assert_close(differences[solution]['y'], size, (plot, solution), 1e-14)

    def test_4_the_simulation_has_its_band(self):
        bands = [t for t in self.traces('case-1-density-y') if t['skip'] and t['group'] == 'mcs']
        self.assertEqual([t['axis'] for t in bands], ['y', 'y', 'y2', 'y2'])
        lower, upper = bands[0]['y'], bands[1]['y']
        simulated = self.curves('case-1-density-y', 'y')['mcs']['y']
        self.assertTrue(all(a <= p <= b for a, p, b in zip(lower, simulated, upper)))

    def test_5_a_click_in_a_legend_toggles_a_solution_in_all_plots(self):
        plots = ('case-1-density-y', 'case-1-density-ydot')

        def visible():
            return {(plot, t['axis'], t['visible']) for plot in plots for t in self.traces(plot)
                    if t['group'] == 'fd-kf'}

        def all_are(value):
            return {(plot, axis, value) for plot in plots for axis in ('y', 'y2', 'y3')}

        self.assertEqual(visible(), all_are(True))
        shown = 'document.querySelectorAll("#case-1-density-y .scatterlayer .trace").length'
        before = self.script(f'return {shown}')
        for expected in ('legendonly', True):
            self.click_legend('case-1-density-y', 'fd-kf')
            WebDriverWait(self.browser, 10).until(lambda _: visible() == all_are(expected))
            if expected == 'legendonly':
                self.assertLess(self.script(f'return {shown}'), before)

    def click_legend(self, plot, name):
        entries = self.browser.find_elements(By.CSS_SELECTOR, f'#{plot} .legend .traces')
        entry = next(e for e in entries if e.find_element(By.CSS_SELECTOR, '.legendtext').text == name)
        toggle = entry.find_element(By.CSS_SELECTOR, '.legendtoggle')
        self.script('arguments[0].scrollIntoView({block: "center"})', entry)
        ActionChains(self.browser).move_to_element(toggle).click().perform()

    def test_6_hovering_shows_values(self):
        plot = self.browser.find_element(By.CSS_SELECTOR, '#case-1-density-y .xy .nsewdrag, '
                                                          '#case-1-density-y .nsewdrag')
        self.script('arguments[0].scrollIntoView({block: "center"})', plot)
        ActionChains(self.browser).move_to_element(plot).perform()
        WebDriverWait(self.browser, 10).until(lambda _: 'fd-kf' in self.script(
            'return document.querySelector("#case-1-density-y .hoverlayer").textContent'))

    def test_7_heat_maps_show_the_selected_solution(self):
        if not self.script('return document.getElementById("case-1-joint-choice") !== null'):
            self.skipTest('this run has no joint densities')
        maps = '''
            const z = part => document.getElementById(`case-1-joint-${part}`).data[0].z.flat();
            const [r, c, d] = ['reference', 'chosen', 'difference'].map(z);
            const {x, y} = document.getElementById('case-1-joint-difference').data[0], nx = x.length - 1;
            const area = k => (x[k % nx + 1] - x[k % nx]) * (y[Math.floor(k / nx) + 1] - y[Math.floor(k / nx)]);
            const option = document.getElementById('case-1-joint-choice').selectedOptions[0].textContent;
            return {l1: d.reduce((sum, one, k) => sum + Math.abs(one) * area(k), 0),
                    mass: r.reduce((sum, p, k) => sum + p * area(k), 0),
                    told: Number(option.match(/L1 (.*)\\)/)[1]), cells: r.length,
                    worst: Math.max(...r.map((p, k) => Math.abs(c[k] - p - d[k]))),
                    largest: Math.max(...d.map(Math.abs)), peak: Math.max(...r),
                    name: document.getElementById('case-1-joint-name').textContent};'''
        choose = '''
            const select = document.getElementById(`case-1-joint-${arguments[0]}`);
            select.selectedIndex = arguments[1];
            select.dispatchEvent(new Event('change'));'''
        first = self.script(maps)
        self.assertGreater(first['cells'], 1000)
        self.assertLess(first['worst'], 1e-6 * first['peak'])
        self.assertGreater(first['largest'], 0)
        # The page prints two digits, and the map ends where the density is 1e-5 of its peak.
        self.assertAlmostEqual(first['mass'], 1, delta=1e-3)
        self.assertAlmostEqual(first['l1'] / first['told'], 1, delta=0.07)
        self.script(choose, 'choice', 1)
        second = self.script(maps)
        self.assertNotEqual(first['name'], second['name'])
        self.assertNotEqual(first['largest'], second['largest'])
        self.script(choose, 'scale', 1)
        logarithmic = self.script('return document.getElementById("case-1-joint-reference").data[0]')
        self.assertAlmostEqual(logarithmic['zmax'] - logarithmic['zmin'], 5)
        self.script(choose, 'scale', 0)

    def test_8_fits_screens_of_both_widths(self):
        for size in (DESKTOP, PHONE):
            self.open_page(size)
            with self.subTest(width=size[0]):
                self.assertLessEqual(self.script('return document.documentElement.scrollWidth'), size[0])
                plots = self.script('''
                    return [...document.querySelectorAll('.plot')].map(plot => {
                      const box = e => { const b = e.getBoundingClientRect();
                                         return {left: b.left, right: b.right, top: b.top, bottom: b.bottom}; };
                      const all = selector => [...plot.querySelectorAll(selector)].map(box);
                      return {id: plot.id, box: box(plot), drawing: all('.main-svg').slice(0, 1), areas: all('.nsewdrag'),
                              caption: box(plot.parentElement.querySelector('figcaption')),
                              titles: all('.xtitle, .x2title, .x3title'), legend: all('.legend'),
                              ticks: all('.xtick, .ytick, .x3tick')};
                    });''')
                self.assertGreater(len(plots), 4)
                for plot in plots:
                    self.check_layout(plot, size)
        self.open_page(DESKTOP)

    def test_9_fits_paper(self):
        self.browser.execute_cdp_cmd('Emulation.setEmulatedMedia', {'media': 'print'})
        self.script('window.dispatchEvent(new Event("beforeprint"))')
        widths = self.script('return [...document.querySelectorAll("table, .main-svg")].map('
                             'e => [e.textContent.slice(0, 40), e.getBoundingClientRect().width])')
        right = self.script('return document.querySelector("main").getBoundingClientRect().width')
        self.assertGreater(len(widths), 10)
        self.assertEqual([one for one in widths if one[1] > right + 1], [])
        self.assertEqual(self.script('return getComputedStyle(document.querySelector("nav")).display'), 'none')
        self.script('window.dispatchEvent(new Event("afterprint"))')
        self.browser.execute_cdp_cmd('Emulation.setEmulatedMedia', {'media': ''})

    def test_10_the_first_column_of_a_scrolled_table_is_fixed(self):
        self.open_page(PHONE)
        moved = self.script('''
            const box = [...document.querySelectorAll('.scroll')].find(e => e.scrollWidth > e.clientWidth + 100);
            const names = [...box.querySelectorAll('tr > th:first-child')];
            const left = () => names.map(e => e.getBoundingClientRect().left);
            const before = left();
            box.scrollLeft = 100;
            return left().map((x, k) => Math.abs(x - before[k]));''')
        self.assertGreater(len(moved), 1)
        self.assertLess(max(moved), 1)
        self.open_page(DESKTOP)

    def test_12_the_first_screen_has_the_verdict_and_a_figure(self):
        bottom = self.script('window.scrollTo(0, 0); return [".answer", ".matrix", ".strip"].map('
                             'e => document.querySelector(e).getBoundingClientRect().bottom)')
        self.assertLessEqual(max(bottom), DESKTOP[1])

    def test_13_follows_the_colour_scheme_and_prints_light(self):
        background = 'return getComputedStyle(document.body).backgroundColor'
        plot = 'return document.querySelector("#case-1-density-y").layout.paper_bgcolor'
        scheme = lambda value: [{'name': 'prefers-color-scheme', 'value': value}]
        for value, page, paper in (('dark', 'rgb(21, 24, 28)', '#15181c'), ('light', 'rgb(255, 255, 255)', '#ffffff')):
            self.browser.execute_cdp_cmd('Emulation.setEmulatedMedia', {'features': scheme(value)})
            self.assertEqual(self.script(background), page)
            WebDriverWait(self.browser, 10).until(lambda _: self.script(plot) == paper)
        self.browser.execute_cdp_cmd('Emulation.setEmulatedMedia', {'media': 'print', 'features': scheme('dark')})
        self.script('window.dispatchEvent(new Event("beforeprint"))')
        self.assertEqual((self.script(background), self.script(plot)), ('rgb(255, 255, 255)', '#ffffff'))
        self.script('window.dispatchEvent(new Event("afterprint"))')
        self.browser.execute_cdp_cmd('Emulation.setEmulatedMedia', {'media': '', 'features': scheme('light')})

    def test_11_ticks_of_all_axes_have_one_size(self):
        sizes = self.script('''
            return [...document.querySelectorAll('#case-1-density-y .xtick text, #case-1-density-y .y2tick text')]
                   .map(e => parseFloat(getComputedStyle(e).fontSize));''')
        self.assertGreater(len(sizes), 4)
        self.assertEqual(set(sizes), {12})

    def check_layout(self, plot, size):
        name = plot['id']
        box, drawing = plot['box'], plot['drawing'][0]
        self.assertGreater(box['right'] - box['left'], 200, name)
        self.assertGreater(box['bottom'] - box['top'], 200, name)
        self.assertLessEqual(drawing['right'], size[0], name)
        self.assertAlmostEqual(drawing['bottom'] - drawing['top'], box['bottom'] - box['top'], delta=2, msg=name)
        self.assertLessEqual(plot['caption']['bottom'], drawing['top'] + 1, name)
        for area in plot['areas']:
            self.assertGreater(area['right'] - area['left'], 180, name)
            self.assertGreater(area['bottom'] - area['top'], 150, name)
        for legend in plot['legend']:
            self.assertLessEqual(legend['bottom'], box['bottom'] + 1, name)
            self.assertLessEqual(legend['right'], box['right'] + 1, name)
            for text in plot['titles'] + plot['ticks']:
                self.assertLessEqual(text['bottom'], legend['top'] + 1, name)


if __name__ == '__main__':
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    DIRECTORY = pathlib.Path(sys.argv.pop(1))
    unittest.main(verbosity=2)
