function run = read_run(directory)
% Reads the densities of a run of fpkcheck, in MATLAB or in Octave with the package netcdf:
%     run = read_run('fpkcheck-out');  one = run.case1;
%     contour(one.y, one.ydot, one.p(:, :, strcmp(one.solutions, 'fd-kf')))
%     plot(one.marginals.fd_kf.y.abscissa, one.marginals.fd_kf.y.density)
%
% Each case is a field with its name; characters other than letters and digits become '_'. Its fields are
%     solutions            ids of the solutions, a cell array
%     y, ydot              centres of the cells; y_bounds, ydot_bounds: edges of the cells, of shape (2, n)
%     p                    joint densities (ydot, y, solution), averages over cells; NaN without a density
%     marginals.ID.y, .ydot  abscissa, density, lower, upper of each bin; NaN without a confidence interval
  if exist('OCTAVE_VERSION', 'builtin')
    pkg load netcdf
  end
  run = with_joint_densities(struct(), fullfile(directory, 'joint.nc'));
  run = with_marginals(run, fullfile(directory, 'marginals.csv'));
end

function run = with_joint_densities(run, file)
  if ~exist(file, 'file'), return, end
  solutions = deblank(strrep(cellstr(ncread(file, 'solution')'), char(0), ' '));  % short ids are padded with zeros
  info = ncinfo(file);
  for variable = {info.Variables.Name}
    if ~strncmp(variable{1}, 'p_', 2), continue, end
    name = variable{1}(3:end);
    one = struct('solutions', {solutions}, 'p', double(ncread(file, variable{1})));
    for axis = {'y', 'ydot'}
      one.(axis{1}) = ncread(file, [axis{1} '_' name]);
      one.([axis{1} '_bounds']) = ncread(file, [axis{1} '_' name '_bounds']);
    end
    run.(field_name(ncreadatt(file, variable{1}, 'case'))) = one;
  end
end

function run = with_marginals(run, file)
  id = fopen(file);
  columns = textscan(id, '%s %s %s %f %f %f %f', 'Delimiter', ',', 'HeaderLines', 1, 'EmptyValue', NaN);
  fclose(id);
  [names, ~, of_case] = unique(columns{1});
  [ids, ~, of_solution] = unique(columns{2});
  for c = 1:numel(names)
    for s = 1:numel(ids)
      for variable = {'y', 'ydot'}
        rows = of_case == c & of_solution == s & strcmp(columns{3}, variable{1});
        if ~any(rows), continue, end
        run.(field_name(names{c})).marginals.(field_name(ids{s})).(variable{1}) = struct( ...
          'abscissa', columns{4}(rows), 'density', columns{5}(rows), ...
          'lower', columns{6}(rows), 'upper', columns{7}(rows));
      end
    end
  end
end

function name = field_name(text)
  name = regexprep(text, '[^A-Za-z0-9]', '_');
  if ~isletter(name(1)), name = ['x' name]; end
end
