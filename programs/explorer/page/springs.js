// A spring between two points, as a zigzag.
export function springs([x0, y0], [x1, y1], turns = 9, width = 0.05) {
    const length = Math.hypot(x1 - x0, y1 - y0);
    if (length < 1e-9) return [[x0, y0], [x1, y1]];
    const [tx, ty] = [(x1 - x0) / length, (y1 - y0) / length], a = Math.min(width, length / 6);
    const points = [[x0, y0]];
    for (let k = 0; k < turns; ++k) {
        const s = length * (0.15 + (0.7 * (k + 0.5)) / turns), side = k % 2 ? -a : a;
        points.push([x0 + s * tx - side * ty, y0 + s * ty + side * tx]);
    }
    points.push([x1, y1]);
    return points;
}
