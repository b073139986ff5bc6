// Zeeman's catastrophe machine: a disc that turns about its centre, a point of its rim held by two elastics, one end fixed at
// (0, -anchor), the other one moved over the table. The elastics have the energy of Green's strain, e = (l^2 - rest^2) / (2 rest^2):
// the potential is then a polynomial, and no length of an elastic an unknown that might be negative. The diamond with its four
// cusps is there as with Hooke's elastics, at slightly other places.
const file = {
    name: 'Zeeman’s catastrophe machine', angles: ['t'], parameters: {x: 0.4, y: 4, anchor: 4, rest: 2},
    definitions: {px: 'sin(t)', py: 'cos(t)', below: 'px^2 + (py + anchor)^2', above: '(px - x)^2 + (py - y)^2'},
    potential: '((below - rest^2)^2 + (above - rest^2)^2)/(8*rest^2)',
};

export const zeeman = {
    id: 'zeeman', tab: 'Zeeman’s machine',
    hint: 'Two elastics hold the rim of a disc; you drag the end of one. Leave the diamond on another side than you came in, and the disc jumps.',
    labels: {t: 'angle of the disc', x: 'x of the free end', y: 'y of the free end', anchor: 'distance of the fixed end', rest: 'length of the elastics at rest'},
    symbols: {t: 'θ', x: 'x', y: 'y'},
    model: () => file,
    start: () => ({parameters: {...file.parameters}, x: ['x', -4, 4], y: ['y', 0, 8], line: 'x'}),
    range(name) {
        return {x: [-4, 4], y: [0, 8], anchor: [1.5, 6], rest: [0.5, 4]}[name];
    },
    locus: () => 'traced', diagram: () => 'traced', follows: true,
    presets: [
        {name: 'the diamond', note: 'four cusps', state: {}},
        {name: 'its lower cusp', note: 'y = 2.48', state: {parameters: {x: 0.05, y: 2.6}, x: ['x', -0.6, 0.6], y: ['y', 2.2, 3.2]}},
        {name: 'long elastics', note: 'elastics longer at rest: more folds, more cusps', state: {parameters: {rest: 3.2}}},
    ],
    sketch(state, [t], p) {
        const rim = [Math.sin(t), Math.cos(t)];
        return {
            discs: [[0, 0, 1]], rods: [[[0, 0], rim]], thin: [[rim, [0, -p.anchor]], [rim, [p.x, p.y]]],
            pivots: [[0, 0], [0, -p.anchor]], masses: [[...rim, 0.6]], blocks: [[p.x, p.y, 0.5]],
        };
    },
    extent: (state, p) => {
        const width = Math.max(1.1, Math.abs(p.x) + 0.2), low = -p.anchor - 0.3, high = Math.max(1.2, p.y + 0.3);
        return [-width, width, low, high];
    },
};
