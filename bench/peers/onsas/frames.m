% One of the frames of bench/peers/finite_rotations in ONSAS: frames(problem, elements, steps, side, last_step) prints a
% line "point load x y z" for each step, of the loaded node, and "seconds S unknowns N". side: a dead load out of the plane,
% as a part of the load that a step has. last_step: it ends with this one of the steps. ONSAS' folder src must be on the
% path; its files go to ./output.
function frames(problem, elements, steps, side, last_step)
  fixed = 1:6; % ux rx uy ry uz rz: ONSAS' order
  planar = [2 4 5];
  switch problem
    case 'lee_frame'
      short = max(1, round(elements / 10));
      lines = {[0 0 0], [0 120 0], round(elements / 2); [0 120 0], [24 120 0], short; ...
               [24 120 0], [120 120 0], elements - round(elements / 2) - short};
      foot = end_of = [1 2 3 4 5];
      others = planar;
      loaded = 2;
      force = [0 0 -1 0 0 0];
      section = [6 1 2 2]; % A J Iy Iz
      material = [720 0];
      arc = 2.2 * sqrt(elements);
      first = 0.2;
    case 'williams_toggle'
      half = round(elements / 2);
      lines = {[-12.943 0 0], [0 .386 0], half; [0 .386 0], [12.943 0 0], half};
      foot = end_of = fixed;
      others = planar;
      loaded = 1;
      force = [0 0 -1 0 0 0];
      e = 1.03e7;
      section = [1.885e6 / e, 1, 9.27e3 / e, 9.27e3 / e];
      material = [e 0];
      arc = 0.007 * sqrt(elements);
      first = 5;
    case 'right_angle_frame'
      half = round(elements / 2);
      lines = {[0 0 0], [240 0 0], half; [240 0 0], [240 -240 0], half};
      foot = fixed;
      end_of = others = [];
      loaded = 2;
      force = [1 0 0 0 side 0]; % side: along z
      section = [18 2.16 .54 1350]; % local y is in the plane
      material = [71240 .31];
      arc = 0;
    case 'bend'
      angles = (0:elements)' * pi / 4 / elements;
      nodes = [100 * sin(angles), 100 * (1 - cos(angles)), 0 * angles];
      foot = fixed;
      end_of = others = [];
      loaded = 0;
      force = [0 0 0 0 1 0];
      section = [1 1/6 1/12 1/12]; % G J = 8.3333e5 with G = E / 2
      material = [1e7 0];
      arc = 0;
  end
  if ~exist('nodes', 'var')
    nodes = lines{1, 1};
    ends = 1;
    for k = 1:rows(lines)
      t = (1:lines{k, 3})' / lines{k, 3};
      nodes = [nodes; (1 - t) * lines{k, 1} + t * lines{k, 2}];
      ends(end + 1) = rows(nodes);
    end
  else
    ends = [1 rows(nodes)];
    loaded = 1;
  end
  load_node = ends(1 + loaded);
  last = rows(nodes);

  materials.modelName = 'elastic-rotEngStr';
  materials.modelParams = material;
  el = struct();
  el(1).elemType = 'node';
  el(2).elemType = 'frame';
  el(2).elemCrossSecParams = {'generic'; section};
  conditions = struct();
  kinds = {foot, others, others, end_of}; % foot, load, other nodes, end
  conditions(4).imposDispDofs = [];
  mesh.nodesCoords = nodes;
  mesh.conecCell = {};
  used = [1 2];
  mesh.conecCell{end + 1, 1} = [0 1 1 1];
  mesh.conecCell{end + 1, 1} = [0 1 2 load_node];
  if ~isempty(others)
    used = 1:4;
    for k = setdiff(2:last - 1, load_node)
      mesh.conecCell{end + 1, 1} = [0 1 3 k];
    end
    mesh.conecCell{end + 1, 1} = [0 1 4 last];
  end
  conditions = struct();
  for k = used
    conditions(k).imposDispDofs = kinds{k};
    conditions(k).imposDispVals = 0 * kinds{k};
  end
  conditions(2).loadsCoordSys = 'global';
  conditions(2).loadsTimeFact = @(t) t;
  conditions(2).loadsBaseVals = force;
  for k = 1:last - 1
    mesh.conecCell{end + 1, 1} = [1 2 0 k k + 1];
  end

  settings = struct();
  settings.stopTolDeltau = 1e-6; % with 1e-9 the loads are the same to 1e-10, for a fifth more time
  settings.stopTolForces = 1e-6;
  settings.stopTolIts = 30;
  if arc
    settings.methodName = 'arcLength';
    settings.deltaT = 1;
    settings.finalTime = last_step;
    settings.incremArcLen = arc * 60 / steps;
    settings.iniDeltaLamb = first;
    settings.posVariableLoadBC = 2;
  else
    most = 600;
    if strcmp(problem, 'right_angle_frame')
      most = 1.4;
    end
    settings.methodName = 'newtonRaphson';
    settings.deltaT = most / steps;
    settings.finalTime = most * last_step / steps;
  end
  other = struct('problemName', 'frame');

  begin = tic;
  [solution, properties, data] = initONSAS(materials, el, conditions, struct(), mesh, settings, other);
  [displacements, factors] = solveONSAS(solution, properties, data);
  seconds = toc(begin);
  node = 6 * (load_node - 1);
  for k = 1:columns(displacements)
    printf('point %.15g %.15g %.15g %.15g\n', factors(k, 2), nodes(load_node, :)' + displacements(node + [1 3 5], k));
  end
  printf('seconds %.6g unknowns %d\n', seconds, length(data.neumDofs));
end
