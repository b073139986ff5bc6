// The holonomic mechanism of docs/mechanism.md (examples/models/holonomic_mechanism.json, put here by the bundler).
import file from '../../../examples/models/holonomic_mechanism.json';
import {springs} from './springs.js';

export const mechanism = {
    id: 'mechanism', tab: 'Mechanism',
    hint: 'Three rods, a slider, two springs and a force F on the end mass. Drag the point through stiffness and force, or let the mechanism go.',
    labels: {
        q1: 'q₁', q2: 'q₂', mass_1: 'mass m₁ [kg]', mass_2: 'mass m₂ [kg]', mass_3: 'mass m₃ [kg]', gravity: 'gravity [m/s²]', length: 'length [m]',
        stiffness_1: 'stiffness c₁ [N/m]', stiffness_2: 'stiffness c₂ [N/m]', force: 'force F [N]', damping: 'damping [N s/m]', decay: 'decay [1/s]',
    },
    symbols: {stiffness_1: 'c₁ [N/m]', stiffness_2: 'c₂ [N/m]', force: 'F [N]', q1: 'q₁', q2: 'q₂'},
    model: () => file,
    start: () => ({parameters: {...file.parameters, stiffness_2: 90, force: 20}, x: ['stiffness_2', 0, 600], y: ['force', -300, 300], line: 'stiffness_2'}),
    range(name) {
        return {stiffness_1: [0, 600], stiffness_2: [0, 600], force: [-300, 300], gravity: [0, 20], length: [0.2, 3], damping: [0, 400], decay: [0, 2]}[name] ?? [0.5, 30];
    },
    limits: name => (name === 'force' ? [-1200, 1200] : [0, 4 * mechanism.range(name)[1]]),
    hidden: ['damping', 'decay', 'mass_3'],
    locus: () => 'traced', diagram: () => 'traced',
    presets: [
        {name: 'stiffness and force', note: 'ten cusps, six regions', state: {}},
        {name: '100 N', note: 'as Vesovic and Radulovic compute it: four equilibria, one of them stable', state: {parameters: {stiffness_2: 1100 / 3, force: 100}}},
        {name: 'no force', note: 'four pitchforks as c₂ grows', state: {parameters: {stiffness_2: 60, force: 0}, line: 'stiffness_2'}},
    ],
    motion: {
        until: 60, speed: 4, start: [0.9666, 0.4488],
    },
    sketch(state, [q1, q2], p) {
        const l = p.length, x1 = l * Math.cos(q1), y1 = l * Math.sin(q1);
        const x2 = x1 - l * Math.sin(q2), y2 = y1 - l * Math.cos(q2), x3 = x1 + l * Math.sqrt(3 + Math.cos(q1) ** 2);
        const push = 0.6 * Math.sign(p.force) * Math.min(1, 0.25 + Math.abs(p.force) / 200) * l;
        return {
            rods: [[[0, 0], [x1, y1], [x2, y2]], [[x1, y1], [x3, 0]]],
            thin: [springs([0, 0], [x2, y2]), springs([0, l], [x1, y1])],
            ground: [[-1.2 * l, -0.09 * l], [3.1 * l, -0.09 * l]],
            masses: [[x1, y1, 0.8], [x2, y2, 0.8]], blocks: [[x3, 0, 0.9]], pivots: [[0, 0], [0, l]],
            arrows: push ? [[[x2, y2], [x2 + push, y2]]] : [],
        };
    },
    extent: (state, p) => [-2.1 * p.length, 3.2 * p.length, -2.1 * p.length, 2.1 * p.length],
};
