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
        const failure = new Error(where ? `not JSON: line ${where.line}, column ${where.column}: ${error.message.replace(/ \(line .*\)$| at position \d+.*/, '')}` : error.message);
        failure.offset = offset;
        throw failure;
    }
}

// Where in the text of a model stands the place that the engine names: "potential, line 1, column 7 = ..", "definitions.x2, ..",
// "equations[1], ..", line and column in the formula; null if it names none.
export function offset_of(text, message) {
    const found = /(\w+)(?:\.(\w+))?(?:\[(\d+)\])?, line (\d+), column (\d+)/.exec(message);
    if (!found) return null;
    const [, key, member, entry, line, column] = found;
    const behind = (pattern, from) => {
        const at = pattern.exec(text.slice(from));
        return at ? from + at.index + at[0].length : null;
    };
    let start = behind(new RegExp(`"${key}"\\s*:\\s*`), 0);
    if (start !== null && member) start = behind(new RegExp(`"${member}"\\s*:\\s*`), start);
    if (start !== null && entry !== undefined) {
        start = behind(/\[\s*/, start);
        for (let k = 0; k < Number(entry) && start !== null; ++k) start = behind(/"(?:[^"\\]|\\.)*"\s*,\s*/, start);
    }
    return start === null || Number(line) !== 1 ? null : start + Number(column);
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
        return {discs: angles ? [[0, 0, 1]] : [], rods: [...rods, ...bars], masses, pivots: angles ? [[0, 0]] : []};
    },
    extent: (state, p, {angles, size}) => [-1.1, 1.1, -1.15 - 0.22 * (size - angles), angles ? 1.1 : -1.05],
};
