// The rotating body with an elastic beam of docs/body-beam.md, one mode a direction: a study of the engine, no formula. An equilibrium
// is a uniform rotation about the axis n (up to its sense) with the beam bent by u; drawn in the body's frame, as are motions.
const file = {
    study: 'body_beam', name: 'rotating body with a beam', coordinates: ['n1', 'n2', 'n3', 'u1', 'u2', 'u3', 'moment', 'speed'],
    parameters: {bending_2: 1.2, momentum: 6, bending_1: 1, stretching: 100, inertia_1: 1.2, inertia_2: 1.3, inertia_3: 0.8, body_mass: 2, length: 1, coupling: 0, damping: 0.3},
};

// The eye is where these are right and up; the body's third axis, along which the beam lies, is nearly upright.
const turn = 0.62, tilt = 0.3;
const right = [-Math.sin(turn), Math.cos(turn), 0], up = [-Math.sin(tilt) * Math.cos(turn), -Math.sin(tilt) * Math.sin(turn), Math.cos(tilt)];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const seen = r => [dot(r, right), dot(r, up)];
const along = (from, direction, s) => from.map((x, i) => x + s * direction[i]);

// The faces towards the eye of the box with the body's moments, at a third of its size: it would hide the beam.
function box(p) {
    const moments = [p.inertia_1, p.inertia_2, p.inertia_3], sum = moments.reduce((a, b) => a + b);
    const h = moments.map(moment => Math.min(0.42 * p.length, (0.33 / 2) * Math.sqrt(Math.max(0.02, (6 * (sum - 2 * moment)) / p.body_mass))));
    const faces = [0, 1, 2].map(k => [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([a, b]) => {
        const corner = [0, 0, 0];
        corner[k] = h[k];
        corner[(k + 1) % 3] = a * h[(k + 1) % 3];
        corner[(k + 2) % 3] = b * h[(k + 2) % 3];
        return seen(corner);
    }));
    return {faces, height: h[2]};
}

// The beam's point at z of [0, 1], for the modes sqrt(5) z^2 and sqrt(3) z of a beam of length 1.
const place = (u, length, z) => [0, 1, 2].map(i => (i < 2 ? Math.sqrt(5) * z * z : Math.sqrt(3) * z) * u[i] / Math.sqrt(length) + (i === 2 ? z * length : 0));
const direction = ({tilt, heading}) => [Math.sin(tilt) * Math.cos(heading), Math.sin(tilt) * Math.sin(heading), Math.cos(tilt)];

export const body = {
    id: 'body', tab: 'Body with a beam',
    hint: 'A body with an elastic beam turns freely in space. Drag the point: each picture is a uniform rotation about the dashed axis.',
    labels: {
        n1: 'n₁', n2: 'n₂', n3: 'n₃', moment: 'moment about the axis λ', speed: 'speed ω', momentum: 'angular momentum |a|', bending_1: 'bending stiffness μ₁', bending_2: 'bending stiffness μ₂',
        stretching: 'stretching stiffness μ₃', inertia_1: 'moment of the body I₁', inertia_2: 'moment of the body I₂', inertia_3: 'moment of the body I₃', body_mass: 'mass of the body', length: 'length of the beam',
    },
    symbols: {moment: 'λ', speed: 'ω', momentum: '|a|', bending_1: 'μ₁', bending_2: 'μ₂', stretching: 'μ₃', inertia_1: 'I₁', inertia_2: 'I₂', inertia_3: 'I₃', body_mass: 'mass', length: 'ℓ'},
    model: () => file,
    start: () => ({parameters: {...file.parameters}, x: ['bending_2', 0.7, 1.7], y: ['momentum', 3, 9], line: 'momentum', show: 6}),
    range(name, value = 1) {
        return {momentum: [3, 12], stretching: [20, 200]}[name] ?? [0.5 * value, 1.5 * value];
    },
    // Nothing below a tenth of what a body has by default: all must be positive.
    limits: name => [0.1 * file.parameters[name], 10 * file.parameters[name]],
    hidden: ['coupling', 'damping'],
    wait: 'solving two bodies in general, from whose solutions all others are followed …',
    grid: 20,
    room: () => '540px',
    locus: ({x, y}) => ([x[0], y[0]].includes('momentum') ? 'curves, then counted' : 'counted'),
    why_not_traced: 'they are where one of the axes is the momentum',
    diagram: ({line}) => (line === 'momentum' ? 'traced' : 'counted'),
    presets: [
        {name: 'linear strain', note: 'the energy of the beam is Baillieul’s: bending and stretching apart', state: {}},
        {name: 'stiffened by tension', note: 'the strain of second order: a beam that is pulled bends less. One mode makes it too stiff', state: {parameters: {coupling: 1, stretching: 20}, y: ['momentum', 3, 8]}},
        {name: 'a long body', note: 'moments 0.3, 1, 1: more rotations', state: {parameters: {inertia_1: 0.3, inertia_2: 1, inertia_3: 1, bending_2: 0.6, momentum: 8}, x: ['bending_2', 0.3, 1.2]}},
        {name: 'where it whirls', note: 'the spin about the beam begins to whirl in either plane', state: {parameters: {momentum: 5.1}, x: ['bending_2', 0.9, 1.5], y: ['momentum', 4, 6.5]}},
    ],
    motion: {
        until: 80, speed: 2, unit: 'units of time',
        sliders: [
            ['tilt', 'tilt of the momentum from the beam [rad]', 0, Math.PI, 0.05], ['heading', 'towards, from the first axis [rad]', -Math.PI, Math.PI, 0.9], ['damping', 'damping of the beam', 0, 1, 0.3],
        ],
        place: values => [...direction(values), 0, 0, 0, 0, 0],
        away: (q, e) => Math.min(...[1, -1].map(sign => Math.hypot(...e.q.slice(0, 6).map((v, i) => (i < 3 ? sign * v : v) - q[i])))),
        ghost: sketch => ({rods: sketch.rods, arrows: sketch.arrows}),
    },
    sketch(state, q, p) {
        const n = q.slice(0, 3), u = q.slice(3, 6), l = p.length, {faces, height} = box(p), pieces = 24, beam = [], sum = [0, 0, 0];
        for (let k = 0; k <= pieces; ++k) {
            const r = place(u, l, k / pieces), weight = (k % pieces ? 1 : 0.5) * (l / pieces);
            r.forEach((x, i) => (sum[i] += weight * x));
            if (r[2] > height || k === pieces) beam.push(seen(r));
        }
        const centre = sum.map(x => x / (p.body_mass + l)), from = seen(along(centre, n, -0.95 * l)), to = seen(along(centre, n, 0.95 * l));
        return {faces, rods: [beam], dashes: [[from, to]], arrows: [[seen(along(centre, n, 0.94 * l)), to]]};
    },
    // As far as the tips reach.
    extent(state, {length}, {equilibria}) {
        const tips = equilibria.map(e => seen(place(e.q.slice(3, 6), length, 1))), far = (k, least) => Math.max(least * length, ...tips.map(tip => 1.06 * Math.abs(tip[k])));
        return [-far(0, 1), far(0, 1), -0.8 * length, far(1, 1.2)];
    },
};
