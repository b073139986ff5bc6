// A model of the reader's own, as the JSON of docs/model-files.md. Its shapes are dials: how it looks is not known.
const example = `{
  "name": "my double pendulum between springs",
  "angles": ["t1", "t2"],
  "parameters": {"stiffness": 1.3, "offset": 0.2},
  "definitions": {
    "x1": "sin(t1)",
    "x2": "x1 + sin(t2)"
  },
  "potential": "2*cos(t1) + cos(t2) + 0.5*stiffness*((x1 - offset)^2 + (x2 - offset)^2)"
}`;

// Line and column of a place in a text, from 1.
export function place(text, offset) {
    const before = text.slice(0, offset), line = before.split('\n').length;
    return {line, column: offset - before.lastIndexOf('\n')};
}

// The model in a text, or an error with line and column where JSON says where it broke.
export function parsed(text) {
    try {
        return JSON.parse(text);
    } catch (error) {
        const at = /position (\d+)/.exec(error.message), end = /end of JSON/.test(error.message);
        const offset = at ? Number(at[1]) : end ? text.length : null;
        const where = offset === null ? null : place(text, offset);
        const failure = new Error(where ? `line ${where.line}, column ${where.column}: ${error.message.replace(/ \(line .*\)$| at position \d+.*/, '')}` : error.message);
        failure.offset = offset;
        throw failure;
    }
}

// Where in the text of a model stands the place that the engine names, "potential, line 1, column 7 = ..."; null if it names none.
// Lines and columns are those of the formula, or, of a file, of the file: both are tried.
export function offset_of(text, message) {
    const found = /(?:^|[ :])([A-Za-z_][\w ]*?)?(?:[ ,]+(?:number|entry)? ?(\d+))?, line (\d+), column (\d+)/.exec(message);
    if (!found) return null;
    const [, what = '', , line, column] = found, key = what.trim().split(' ').pop();
    const keyed = key && new RegExp(`"${key}"\\s*:\\s*\\[?\\s*"`).exec(text);
    if (!keyed || Number(line) !== 1) {
        const lines = text.split('\n');
        if (Number(line) > lines.length) return null;
        return lines.slice(0, line - 1).reduce((sum, l) => sum + l.length + 1, 0) + Number(column) - 1;
    }
    return keyed.index + keyed[0].length + Number(column) - 1;
}

export const own = {
    id: 'own', tab: 'Your model',
    hint: 'Write a potential as a formula, and see its equilibria. Then drag the point.',
    example,
    labels: {}, symbols: {},
    model: ({text}) => parsed(text ?? example),
    start({text = example}) {
        const model = parsed(text), names = Object.keys(model.parameters ?? {});
        const axis = name => [name, ...own.range(name, model.parameters[name])];
        return {
            text, parameters: {...model.parameters}, x: names[0] && axis(names[0]), y: names[1] && axis(names[1]),
            line: names[0],
        };
    },
    range: (name, value = 1) => (value > 0 ? [0.25 * value, 2 * value] : value < 0 ? [2 * value, 0.25 * value] : [-1, 1]),
    locus: () => 'traced', diagram: () => 'traced',
    presets: [],
    sketch(state, q, p, {angles}) {
        const n = Math.max(angles, 1), rods = [], masses = [], bars = [];
        for (let i = 0; i < q.length; ++i) {
            const reach = 1 - (0.45 * i) / Math.max(n, 2);
            if (i < angles) {
                const tip = [reach * Math.sin(q[i]), -reach * Math.cos(q[i])];
                rods.push([[0, 0], tip]);
                masses.push([...tip, 0.9 - (0.4 * i) / n]);
            } else {
                const y = -1.25 - 0.18 * (i - angles), x = Math.atan(q[i]) / (Math.PI / 2);
                bars.push([[0, y], [x, y]]);
                masses.push([x, y, 0.5]);
            }
        }
        return {discs: angles ? [[0, 0, 1]] : [], rods: [...rods, ...bars], masses, pivots: [[0, 0]]};
    },
    extent: (state, p, {angles, size}) => [-1.1, 1.1, -1.15 - 0.22 * (size - angles), 1.1],
};
