// The equilibria along the line through the point: one unknown against one parameter, branches by index, folds and pitchforks.
import {scale, tics, svg, angle_tics, wrapped} from './axes.js';
import {index_colour, colour} from './colours.js';
import {written, short} from './names.js';
import {watched_size} from './size.js';

const margin = {left: 44, right: 12, top: 10, bottom: 40};

export class Diagram {
    constructor(host, {moved}) {
        this.svg = host.querySelector('svg');
        this.layers = {};
        for (const name of ['back', 'branches', 'events', 'front', 'now']) this.svg.append((this.layers[name] = svg('g', {class: name})));
        this.size = watched_size(host, () => this.draw());
        addEventListener('colours', () => this.draw());
        let held = false;
        const go = event => {
            if (!this.sx) return;
            const x = this.sx.back(event.clientX - this.svg.getBoundingClientRect().left);
            moved(Math.min(this.range[2], Math.max(this.range[1], x)), event.timeStamp);
        };
        this.svg.addEventListener('pointerdown', event => {
            held = true;
            this.svg.setPointerCapture(event.pointerId);
            go(event);
        });
        this.svg.addEventListener('pointermove', event => held && go(event));
        for (const name of ['pointerup', 'pointercancel']) this.svg.addEventListener(name, () => (held = false));
    }

    // range: [name, low, high]; angles: how many of the unknowns are; show: the number of the unknown drawn.
    frame({range, unknowns, angles, show, symbols, potential}) {
        Object.assign(this, {range, unknowns, angles, show, symbols, potential});
        this.draw();
    }
    set_branches(diagram) {
        this.diagram = diagram;
        this.stale = false;
        this.draw();
    }
    set_samples(samples) {
        this.samples = samples;
        this.draw();
    }
    set_stale(stale) {
        this.stale = stale;
        this.svg.classList.toggle('stale', stale);
    }

    draw() {
        const {width, height} = this.size();
        if (!width || !this.range) return;
        const {left, right, top, bottom} = margin, {back, branches, events, front} = this.layers;
        this.svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
        this.svg.classList.toggle('stale', Boolean(this.stale));
        const [name, low, high] = this.range, angle = this.show < this.angles;
        this.sx = scale([low, high], [left, width - right]);
        const span = angle ? [-Math.PI * 1.04, Math.PI * 1.04] : this.#span();
        this.sy = scale(span, [height - bottom, top]);
        const frame = {x: left, y: top, width: width - right - left, height: height - bottom - top};
        back.replaceChildren(svg('rect', {...frame, class: 'paper'}));
        front.replaceChildren(svg('rect', {...frame, class: 'frame'}));
        for (const {value, text} of tics([low, high], 5))
            front.append(svg('path', {d: `M${this.sx(value)} ${height - bottom}v5`, class: 'tic'}), svg('text', {x: this.sx(value), y: height - bottom + 18, 'text-anchor': 'middle'}, text));
        for (const {value, text} of angle ? angle_tics : tics(span, 4))
            front.append(svg('path', {d: `M${left} ${this.sy(value)}h-5`, class: 'tic'}), svg('text', {x: left - 8, y: this.sy(value) + 4, 'text-anchor': 'end'}, text));
        front.append(svg('text', {x: (left + width - right) / 2, y: height - 4, 'text-anchor': 'middle', class: 'name'}, written(name, this.symbols)));
        branches.replaceChildren();
        events.replaceChildren();
        if (this.diagram) this.#draw_branches();
        else if (this.samples) this.#draw_samples();
        this.now(this.at, this.equilibria);
    }

    #span() {
        const values = (this.diagram ? this.diagram.branches.flatMap(b => b.points.map(p => p[1 + this.show])) : this.samples?.flatMap(s => (s.equilibria ?? []).map(e => e.q[this.show]))) ?? [];
        const all = values.concat((this.equilibria ?? []).map(e => e.q[this.show])).filter(Number.isFinite).slice(0, 20000);
        if (!all.length) return [-1, 1];
        const low = Math.min(...all), high = Math.max(...all), room = 0.06 * (high - low) || 1;
        return [low - room, high + room];
    }
    #value(q) {
        return this.show < this.angles ? wrapped(q) : q;
    }

    #draw_branches() {
        const angle = this.show < this.angles, paths = new Map();
        for (const {index, points} of this.diagram.branches) {
            let d = '', last = null;
            for (const point of points) {
                const x = point[0], y = this.#value(point[1 + this.show]), jump = last !== null && angle && Math.abs(y - last) > Math.PI;
                d += `${last === null || jump ? 'M' : 'L'}${this.sx(x).toFixed(1)} ${this.sy(y).toFixed(1)}`;
                last = y;
            }
            paths.set(index, (paths.get(index) ?? '') + d);
        }
        for (const [index, d] of [...paths].sort((a, b) => b[0] - a[0])) {
            const stable = this.potential && index === 0;
            this.layers.branches.append(svg('path', {d, class: stable ? 'branch stable' : 'branch', stroke: this.potential ? index_colour(index) : colour('ink')}));
        }
        for (const event of this.diagram.events ?? []) {
            const q = [...(event.angles ?? []), ...(event.coordinates ?? [])], x = this.sx(event[this.range[0]]), y = this.sy(this.#value(q[this.show]));
            const title = svg('title', {}, `${event.kind} at ${written(this.range[0], this.symbols)} = ${short(event[this.range[0]], 10)}`);
            this.layers.events.append(event.kind === 'fold'
                ? svg('rect', {x: x - 3.5, y: y - 3.5, width: 7, height: 7, class: 'fold'}, title)
                : svg('circle', {cx: x, cy: y, r: 4, class: 'pitchfork', fill: colour('pitchfork')}, title));
        }
    }

    #draw_samples() {
        const paths = new Map();
        for (const {key, equilibria} of this.samples)
            for (const e of equilibria ?? []) paths.set(e.index, (paths.get(e.index) ?? '') + `M${this.sx(key).toFixed(1)} ${this.sy(this.#value(e.q[this.show])).toFixed(1)}h0`);
        for (const [index, d] of [...paths].sort((a, b) => b[0] - a[0]))
            this.layers.branches.append(svg('path', {d, class: index === 0 ? 'samples stable' : 'samples', stroke: this.potential ? index_colour(index) : colour('ink')}));
    }

    // Where the point is on the line, with its equilibria.
    now(at, equilibria = [], choice = null) {
        this.at = at;
        this.equilibria = equilibria;
        if (!this.sx || at === undefined) return;
        const {height} = this.size(), x = this.sx(at), parts = [svg('path', {d: `M${x} ${margin.top}V${height - margin.bottom}`, class: 'cross cut'})];
        const dots = new Map();
        for (const e of equilibria) dots.set(e.index, (dots.get(e.index) ?? '') + `M${x.toFixed(1)} ${this.sy(this.#value(e.q[this.show])).toFixed(1)}h0`);
        for (const [index, d] of dots) {
            if (this.potential && index === 0) parts.push(svg('path', {d, class: 'dots', stroke: index_colour(0), 'stroke-width': 11}));
            else parts.push(
                svg('path', {d, class: 'dots', stroke: this.potential ? index_colour(index) : colour('ink'), 'stroke-width': 8.5}),
                svg('path', {d, class: 'dots', stroke: colour('panel'), 'stroke-width': 4.5}));
        }
        if (choice) parts.push(svg('circle', {cx: x, cy: this.sy(this.#value(choice.q[this.show])), r: 9, class: 'choice'}));
        this.layers.now.replaceChildren(...parts);
    }
}
