// The curves of the plane, traced; or counts at the points of a grid, where tracing takes long or was not asked for.
import {Overtaken} from './engine.js';
import {locus_in_words} from './words.js';
import {shown, kind, current_locus_key, other_parameters} from './shown.js';
import {$, slow, panels, times} from './parts.js';

const say = text => ($('#locus-status').textContent = text);
const busy = on => ($('#locus-stop').hidden = !on);

export async function trace_plane(how = kind().locus(shown.state)) {
    const key = current_locus_key();
    if (!key) return;
    shown.locus_key = key;
    slow.stop();
    const {x, y} = shown.state, set = {...shown.state.parameters}, asked = shown.generation, parameters = other_parameters([x[0], y[0]]);
    $('#locus-trace').hidden = true;
    $('#argument').hidden = true;
    try {
        busy(true);
        if (how === 'both' || how === 'counted') {
            if (shown.locus) panels.plane.set_locus((shown.locus = null));
            await count_plane(set, say);
        }
        if (how === 'counted') {
            busy(false);
            const why = kind().why_not_traced;
            $('#locus-trace').hidden = Boolean(why);
            const counts = [...panels.plane.raster.cells.values()].map(c => c.count), range = `from ${Math.min(...counts)} (light) to ${Math.max(...counts)} equilibria`;
            return say(`Counted at points: ${range}. The borders between the colours are not traced${why ? `: ${why}` : '; that takes minutes'}.`);
        }
        const {response, milliseconds} = await trace_curves(x, y, set);
        if (asked !== shown.generation) return;
        times.locus = milliseconds;
        shown.locus = Object.assign(response, {key_of_parameters: parameters});
        panels.plane.set_locus(shown.locus);
        tell_locus();
        if (how === 'curves, then counted') await count_plane(set, text => say(`${locus_in_words(response, milliseconds)} ${text}`)).then(tell_locus);
        busy(false);
    } catch (error) {
        if (error instanceof Overtaken) return;
        busy(false);
        say(`${error.message[0]?.toUpperCase() ?? ''}${error.message.slice(1)}`);
        if (how === 'traced' || how === 'curves, then counted') {
            panels.plane.set_locus((shown.locus = null));
            try {
                busy(true);
                await count_plane(set, () => {});
                say(`Counted at points; curves were not traced: ${error.message}`);
            } catch { /* overtaken */ }
            busy(false);
        }
    }
}

function trace_curves([nx, x0, x1], [ny, y0, y1], set) {
    const began = performance.now(), seconds = () => (performance.now() - began) / 1000;
    const tracing = () => say(`Tracing the curves …${seconds() > 2 ? ` ${Math.round(seconds())} s` : ''}`);
    tracing();
    const clock = setInterval(tracing, 1000), request = {command: 'locus', model: shown.model, set, x: {name: nx, low: x0, high: x1}, y: {name: ny, low: y0, high: y1}};
    return slow.run(request, {full: true}).finally(() => clearInterval(clock));
}

async function count_plane(set, tell) {
    const {x: [nx, x0, x1], y: [ny, y0, y1], links} = shown.state, finest = kind().grid ?? (links >= 5 ? 24 : links === 4 ? 48 : 36);
    const raster = {cells: new Map()};
    for (const n of [...[8, 16].filter(v => v < 0.7 * finest), finest]) {
        const wide = (x1 - x0) / n, high = (y1 - y0) / n, points = [];
        for (let j = 0; j < n; ++j)
            for (let i = 0; i < n; ++i) {
                const x = x0 + (i + 0.5) * wide, y = y0 + (j + 0.5) * high;
                points.push({key: {x, y, wide, high}, set: {[nx]: x, [ny]: y}});
            }
        tell(`Counting equilibria at ${n} × ${n} points …`);
        await slow.sweep({command: 'solve', model: shown.model, set, prove: false}, points, rows => {
            for (const {key, by_index, count} of rows) if (by_index) raster.cells.set(`${n} ${key.x} ${key.y}`, {...key, count, by_index});
            panels.plane.set_raster(raster);
        });
    }
    for (const [key, cell] of raster.cells) if (cell.wide > 1.01 * (x1 - x0) / finest) raster.cells.delete(key);
    raster.finished = true;
    panels.plane.set_raster(raster);
}

function tell_locus() {
    say(locus_in_words(shown.locus, times.locus));
    $('#argument').hidden = false;
    $('#argument summary').textContent = shown.locus.evidence.complete ? 'Why no curve is missing' : 'How the curves were found';
    $('#argument p').textContent = shown.locus.argument;
}
