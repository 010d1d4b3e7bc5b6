% Tests examples/read_run.m with a saved run of case1 and case4: masses, marginals of the joint densities, intervals.
% Also runs the Octave code in docs/python.md, without its plots.
%     octave-cli read_run_test.m SOURCES DIR
arguments = argv();
addpath(fullfile(arguments{1}, 'examples'));
run_ = read_run(arguments{2});
assert(sort(fieldnames(run_)), {'case1'; 'case4'})
for name = {'case1', 'case4'}
  one = run_.(name{1});
  assert(one.solutions, {'epc-gaussian-n6'; 'fd-white'; 'mcs'})
  dy = diff(one.y_bounds)';
  dv = diff(one.ydot_bounds)';
  assert(size(one.p), [numel(one.ydot), numel(one.y), 3])
  assert(one.y, mean(one.y_bounds)', 1e-12)
  assert(one.y_bounds(1, 1), 0)
  for k = 1:3
    p = one.p(:, :, k);
    assert(dv' * p * dy, 1, 1e-6)
    marginals = one.marginals.(regexprep(one.solutions{k}, '-', '_'));
    % The height of a cell is two bins of the marginal density.
    p_y = mean(reshape(marginals.y.density, 2, []))';
    assert(sum(abs(p' * dv - p_y) .* dy) < 1e-6)
    assert(sum(abs(p * dy - marginals.ydot.density) .* dv) < 1e-6)
    assert(marginals.ydot.abscissa, one.ydot, 1e-12)
    if strcmp(one.solutions{k}, 'mcs')
      assert(all(marginals.y.lower <= marginals.y.density & marginals.y.density <= marginals.y.upper))
    else
      assert(all(isnan(marginals.y.lower)))
    end
  end
end

block = regexp(fileread(fullfile(arguments{1}, 'docs', 'python.md')), '```matlab(.*?)```', 'tokens'){1}{1};
block = strrep(block, 'fpkcheck-out', arguments{2});
block = strrep(regexprep(block, '(contour|plot)\(([^;\n]*)\)', 'shown = {$2};'), 'fd-kf', 'fd-white');
eval(block)
assert(size(p), [numel(v), numel(y), 3])
assert(double(p), run_.case1.p)
assert(find(strncmp(ids, 'fd-white', 5)), 2)
assert(t{5}(k), run_.case1.marginals.fd_white.y.density)
assert(shown{2}, t{5}(k))
assert(numel(shown{1}), 140)
disp('read_run and docs/python.md: passed')
