// The rotating chain of one to five links in a plane that turns about the vertical; angles from the downward vertical.
import {written} from './names.js';

const range = n => Array.from({length: n}, (_, i) => i + 1);

// Of three links those of examples/models/rotating_chain_of_three_links.json; all different, as equal ones are a special case.
const lengths = [1.1, 1.2, 1.3, 1.15, 1.25], masses = [1.05, 1.2, 1.45, 1.1, 1.3];

// Two links as Baillieul writes them, with alpha = m2 / (m1 + m2) and the ratio of the lengths; others by lengths and masses.
function model(links) {
    const angles = range(links).map(i => `t${i}`);
    if (links === 2)
        return {
            name: 'rotating chain of two links', angles, parameters: {alpha: 0.33, ratio: 1.5, omega: 2},
            definitions: {x1: 'sin(t1)', x2: 'x1 + ratio*sin(t2)'},
            potential: '-0.5*omega^2*((1 - alpha)*x1^2 + alpha*x2^2) - cos(t1) - alpha*ratio*cos(t2)',
        };
    if (links === 1)
        return {
            name: 'rotating pendulum', angles, parameters: {length: 1, omega: 1.5},
            potential: '-0.5*omega^2*length^2*sin(t1)^2 - length*cos(t1)',
        };
    const parameters = {omega: 1.7}, definitions = {};
    for (const i of range(links)) parameters[`l${i}`] = lengths[i - 1];
    for (const i of range(links)) parameters[`m${i}`] = masses[i - 1];
    for (const i of range(links)) {
        definitions[`x${i}`] = `${i > 1 ? `x${i - 1} + ` : ''}l${i}*sin(t${i})`;
        definitions[`z${i}`] = `${i > 1 ? `z${i - 1} + ` : ''}l${i}*cos(t${i})`;
    }
    return {
        name: `rotating chain of ${['', '', '', 'three', 'four', 'five'][links]} links`, angles, parameters, definitions,
        potential: range(links).map(i => `- m${i}*(0.5*omega^2*x${i}^2 + z${i})`).join(' '),
    };
}

function lengths_and_masses(links, p) {
    if (links === 2) return [[1, p.ratio], [1 - p.alpha, p.alpha]];
    if (links === 1) return [[p.length], [1]];
    return [range(links).map(i => p[`l${i}`]), range(links).map(i => p[`m${i}`])];
}

const labels = {length: 'length ℓ', ratio: 'ratio ℓ₂ / ℓ₁', alpha: 'mass ratio α', omega: 'speed ω'};
const symbols = {length: 'ℓ', ratio: 'ℓ₂/ℓ₁', alpha: 'α', omega: 'ω'};
for (const i of range(5)) {
    labels[`t${i}`] = symbols[`t${i}`] = `θ${written(String(i))}`;
    labels[`l${i}`] = `length ℓ${written(String(i))}`;
    labels[`m${i}`] = `mass m${written(String(i))}`;
    symbols[`m${i}`] = `m${written(String(i))}`;
    symbols[`l${i}`] = `ℓ${written(String(i))}`;
}

const starts = {
    1: {parameters: {length: 1, omega: 1.5}, x: ['length', 0.1, 3], y: ['omega', 0, 4]},
    2: {parameters: {alpha: 0.33, ratio: 1.5, omega: 1.8}, x: ['alpha', 0, 1], y: ['omega', 0, 5]},
    3: {parameters: {m3: 0.5, omega: 2}, x: ['m3', 0.1, 2], y: ['omega', 0.5, 5]},
    4: {parameters: {m4: 0.5, omega: 2}, x: ['m4', 0.1, 2], y: ['omega', 0.2, 5]},
    5: {parameters: {m5: 0.5, omega: 2}, x: ['m5', 0.1, 2], y: ['omega', 0.2, 4]},
};

export const chain = {
    id: 'chain', tab: 'Rotating chain',
    hint: 'A chain hangs in a plane that turns about the dashed axis. Drag the point: where it crosses a curve, equilibria are born or die.',
    labels, symbols,
    model: ({links}) => model(links),
    start: ({links}) => ({links, ...starts[links], line: 'omega', parameters: {...model(links).parameters, ...starts[links].parameters}}),
    range(name) {
        if (name === 'alpha') return [0, 1];
        if (name === 'omega') return [0, 6];
        return [name === 'length' || name === 'ratio' ? 0.1 : 0.05, 3];
    },
    // How far the window of the plane may go.
    limits: name => [0, name === 'alpha' ? 1 : 4 * chain.range(name)[1]],
    // Of the shapes; as much as the plane has if it says nothing.
    room: ({links}) => ({4: '640px', 5: '820px'})[links],
    // Curves are traced at once, counted at points first, or only counted and traced when asked for.
    locus: ({links}) => (links < 3 ? 'traced' : links === 3 ? 'both' : 'counted'),
    diagram: ({links}) => (links < 3 ? 'traced' : links === 3 ? 'both' : 'counted'),
    presets: [
        {name: 'Figure 3.2', note: 'Baillieul’s Figure 3.2: two links of length ratio 1.5', state: {links: 2}},
        {name: 'its cusp a', note: 'the cusp at α = 0.3299', state: {links: 2, parameters: {alpha: 0.331, omega: 1.97}, x: ['alpha', 0.316, 0.343], y: ['omega', 1.91, 2.14]}},
        {name: 'its cusp b', note: 'the cusp at α = 0.0034', state: {links: 2, parameters: {alpha: 0.0015, omega: 1.009}, x: ['alpha', 0.00001, 0.0039], y: ['omega', 0.9975, 1.0195]}},
        {name: 'ratio 1.1', note: 'the same plane at another ratio of the lengths', state: {links: 2, parameters: {ratio: 1.1}}},
        {name: 'ratio 2.2', note: 'the same plane at another ratio of the lengths', state: {links: 2, parameters: {ratio: 2.2}}},
        {name: 'one link', note: 'a pendulum that turns: one pitchfork, ω² ℓ = g', state: {links: 1}},
        {name: 'three links', note: 'the mass of the last one, and the speed', state: {links: 3}},
    ],
    sketch({links}, q, p) {
        const [l, m] = lengths_and_masses(links, p), rod = [[0, 0]], masses = [];
        const heaviest = Math.max(...m, 1e-9);
        let x = 0, y = 0;
        for (let i = 0; i < links; ++i) {
            x += l[i] * Math.sin(q[i]);
            y -= l[i] * Math.cos(q[i]);
            rod.push([x, y]);
            masses.push([x, y, 0.35 + 0.65 * Math.sqrt(Math.max(m[i], 0) / heaviest)]);
        }
        return {axis: true, rods: [rod], masses, pivots: [[0, 0]]};
    },
    extent({links}, p) {
        const r = lengths_and_masses(links, p)[0].reduce((a, b) => a + b) * 1.09;
        return [-r, r, -r, r];
    },
};
