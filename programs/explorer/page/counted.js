// The regions that counts at the points of a grid make: connected parts of equal counts. {count, by_index, cells} each; a cell's `steps`
// are those to the border of its part.
export function counted_regions(cells, x0, y0) {
    const wide = Math.min(...cells.map(c => c.wide)), high = Math.min(...cells.map(c => c.high)), grid = new Map();
    for (const cell of cells)
        if (cell.wide < 1.01 * wide) grid.set(`${Math.floor((cell.x - x0) / wide)} ${Math.floor((cell.y - y0) / high)}`, {...cell, key: cell.by_index.join()});
    const neighbours = at => {
        const [i, j] = at.split(' ').map(Number);
        return [`${i - 1} ${j}`, `${i + 1} ${j}`, `${i} ${j - 1}`, `${i} ${j + 1}`];
    };
    const alike = (a, b) => grid.get(a).key === grid.get(b)?.key;
    let front = [...grid.keys()].filter(at => neighbours(at).some(other => !alike(at, other)));
    for (let steps = 1; front.length; ++steps) {
        for (const at of front) grid.get(at).steps = steps;
        front = [...new Set(front.flatMap(at => neighbours(at).filter(other => alike(at, other) && !grid.get(other).steps)))];
    }
    const parts = [], seen = new Set();
    for (const start of grid.keys()) {
        if (seen.has(start)) continue;
        const part = [start];
        seen.add(start);
        for (const at of part)  // grows
            for (const other of neighbours(at).filter(other => alike(at, other) && !seen.has(other))) {
                seen.add(other);
                part.push(other);
            }
        const {count, by_index} = grid.get(start);
        parts.push({count, by_index, cells: part.map(at => grid.get(at))});
    }
    return parts;
}
