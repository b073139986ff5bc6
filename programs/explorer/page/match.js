// Which equilibrium of this frame is which of the last one: the nearest pairs on the torus first. What has no partner was born, or died.
import {wrapped} from './axes.js';

let next = 1;

export function matched(before, now, angles) {
    const distance = (a, b) => {
        let sum = 0;
        for (let i = 0; i < a.length && sum < 1; ++i) {
            const d = i < angles ? wrapped(a[i] - b[i]) : a[i] - b[i];
            sum += d * d;
        }
        return sum;
    };
    for (const e of now) e.id = 0;
    const pairs = [];
    now.forEach((e, i) => before.forEach((old, j) => {
        const d = distance(e.q, old.q);
        if (d < 1) pairs.push([d + (e.index === old.index ? 0 : 0.05), i, j]);
    }));
    pairs.sort((a, b) => a[0] - b[0]);
    const taken = new Set();
    for (const [, i, j] of pairs) {
        if (now[i].id || taken.has(j)) continue;
        now[i].id = before[j].id;
        now[i].born = before[j].born;
        taken.add(j);
    }
    const first = before.length === 0, time = performance.now();
    for (const e of now) {
        if (e.id) continue;
        e.id = next++;
        e.born = first ? -1e9 : time;
    }
    return now;
}
