// All equilibria at the point, each as a small picture, grouped by index. One canvas of a size of its own: nothing on the page moves
// as they come and go. Stable ones are heavy, filled and framed; what is born flashes.
import {colour, index_colour, index_word} from './colours.js';
import {clamp} from './axes.js';
import {counted} from './names.js';
import {watched_size} from './size.js';

const heading = 22, gap = 8, flash = 1100;

// A drawing of a sketch in a box of pixels; the same for small pictures, the followed one and motions. A sketch has, each optional, axis
// (is there one?), dashes, ground, thin and rods (poly-lines), discs, masses and blocks (x, y, size), faces (polygons), pivots, arrows.
export function draw_sketch(context, sketch, extent, [bx, by, bw, bh], {stroke, stable, faint = 1}) {
    const [x0, x1, y0, y1] = extent, s = Math.min(bw / (x1 - x0), bh / (y1 - y0));
    const X = x => bx + bw / 2 + (x - (x0 + x1) / 2) * s, Y = y => by + bh / 2 - (y - (y0 + y1) / 2) * s;
    const small = Math.min(bw, bh), heavy = clamp(small / (stable ? 24 : 42), small < 40 ? 1 : 0.7, stable ? 5 : 3);
    const trace = points => {
        context.beginPath();
        points.forEach(([x, y], i) => (i ? context.lineTo(X(x), Y(y)) : context.moveTo(X(x), Y(y))));
    };
    const line = points => {
        trace(points);
        context.stroke();
    };
    context.save();
    context.globalAlpha = faint;
    context.lineJoin = context.lineCap = 'round';
    context.strokeStyle = colour('guide');
    context.lineWidth = clamp(small / 110, 0.5, 1.2);
    context.setLineDash([clamp(small / 26, 1, 5), clamp(small / 26, 1, 4)]);
    for (const points of [...(sketch.axis ? [[[0, y0], [0, y1]]] : []), ...(sketch.dashes ?? [])]) line(points);
    context.setLineDash([]);
    if (sketch.ground) line(sketch.ground);
    for (const [x, y, r] of sketch.discs ?? []) {
        context.beginPath();
        context.arc(X(x), Y(y), r * s, 0, 2 * Math.PI);
        context.fillStyle = colour('disc');
        context.fill();
        context.stroke();
    }
    for (const points of sketch.faces ?? []) {
        trace(points);
        context.closePath();
        context.fillStyle = colour('disc');
        context.fill();
        context.stroke();
    }
    context.strokeStyle = stroke;
    context.lineWidth = clamp(small / 90, 0.5, 1.4);
    for (const points of sketch.thin ?? []) line(points);
    context.lineWidth = heavy;
    for (const rod of sketch.rods ?? []) line(rod);
    context.fillStyle = stable ? stroke : colour('cell');
    context.lineWidth = clamp(small / 70, 0.6, 1.8);
    const unit = clamp(small / 20, 0.9, 7);
    for (const [x, y, r] of sketch.masses ?? []) {
        context.beginPath();
        context.arc(X(x), Y(y), unit * r, 0, 2 * Math.PI);
        context.fill();
        context.stroke();
    }
    for (const [x, y, r] of sketch.blocks ?? []) {
        context.beginPath();
        context.rect(X(x) - unit * r * 1.3, Y(y) - unit * r, unit * r * 2.6, unit * r * 2);
        context.fill();
        context.stroke();
    }
    context.fillStyle = colour('guide');
    for (const [x, y] of sketch.pivots ?? []) {
        context.beginPath();
        context.arc(X(x), Y(y), clamp(small / 48, 0.6, 2.6), 0, 2 * Math.PI);
        context.fill();
    }
    context.strokeStyle = context.fillStyle = colour('arrow');
    context.lineWidth = clamp(small / 60, 0.7, 2);
    for (const [from, to] of sketch.arrows ?? []) {
        line([from, to]);
        const a = Math.atan2(Y(to[1]) - Y(from[1]), X(to[0]) - X(from[0])), h = clamp(small / 18, 2, 8);
        context.beginPath();
        context.moveTo(X(to[0]) + h * 0.5 * Math.cos(a), Y(to[1]) + h * 0.5 * Math.sin(a));
        for (const side of [-2.5, 2.5]) context.lineTo(X(to[0]) + h * Math.cos(a + side), Y(to[1]) + h * Math.sin(a + side));
        context.fill();
    }
    context.restore();
}

export class Shapes {
    constructor(canvas, {chosen}) {
        this.canvas = canvas;
        this.chosen = chosen;
        this.shown = [];
        this.cells = [];
        this.size = watched_size(canvas, () => this.draw());
        addEventListener('colours', () => this.draw());
        const hit = event => {
            const box = canvas.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
            return this.cells.find(c => x >= c.x && x < c.x + c.w && y >= c.y && y < c.y + c.h)?.equilibrium ?? null;
        };
        canvas.addEventListener('pointermove', event => this.#choose(hit(event), false));
        canvas.addEventListener('pointerleave', () => this.#choose(null, false));
        canvas.addEventListener('click', event => this.#choose(hit(event), true));
        canvas.addEventListener('keydown', event => {
            const step = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1}[event.key];
            if (!step || !this.cells.length) return;
            const at = this.cells.findIndex(c => c.equilibrium.id === (this.pinned ?? this.hover));
            this.#choose(this.cells[(at + step + this.cells.length) % this.cells.length].equilibrium, true, false);
            event.preventDefault();
        });
        this.still = matchMedia('(prefers-reduced-motion: reduce)');
    }

    #choose(equilibrium, pin, toggle = true) {
        const id = equilibrium?.id ?? null;
        if (pin) this.pinned = toggle && this.pinned === id ? null : id;
        if (this.hover === id && !pin) return;
        this.hover = id;
        this.draw();
        this.chosen(this.choice);
    }
    get choice() {
        return this.shown.find(e => e.id === (this.hover ?? this.pinned)) ?? null;
    }

    show(equilibria, {sketch, extent, potential, aspect = 1, followed = null}) {
        Object.assign(this, {shown: equilibria, sketch, extent, potential, aspect, followed});
        if (this.pinned && !equilibria.some(e => e.id === this.pinned)) this.pinned = null;
        this.draw();
    }

    draw() {
        const {width, height} = this.size(), ratio = devicePixelRatio || 1;
        if (!width || !this.sketch) return;
        const context = this.canvas.getContext('2d');
        if (this.canvas.width !== Math.round(width * ratio)) this.canvas.width = Math.round(width * ratio);
        if (this.canvas.height !== Math.round(height * ratio)) this.canvas.height = Math.round(height * ratio);
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        context.clearRect(0, 0, width, height);
        const groups = new Map();
        for (const e of this.shown) (groups.get(e.index) ?? groups.set(e.index, []).get(e.index)).push(e);
        const ordered = [...groups].sort((a, b) => a[0] - b[0]);
        const rows = s => ordered.reduce((sum, [, list]) => sum + Math.ceil(list.length / Math.max(1, Math.floor(width / (s * this.aspect)))), 0);
        let s = 210;
        while (s > 7 && rows(s) * s + ordered.length * (heading + gap) > height) s -= s > 40 ? 2 : 0.5;
        const w = s * this.aspect, inset = s > 40 ? 3 : s > 18 ? 1.5 : 0.5;
        this.cells = [];
        let y = 0;
        const now = performance.now();
        let lively = false;
        for (const [index, list] of ordered) {
            const name = this.potential ? index_word(index) : 'equilibria', stable = this.potential && index === 0;
            const stroke = this.potential ? index_colour(index) : colour('ink');
            context.font = `${stable ? 600 : 400} 13px system-ui, sans-serif`;
            context.fillStyle = stroke;
            context.beginPath();
            if (stable) context.arc(6, y + 11, 5, 0, 7);
            else context.rect(2, y + 7, 8, 8);
            if (stable) context.fill();
            context.strokeStyle = stroke;
            context.lineWidth = 1.6;
            context.stroke();
            context.fillStyle = colour('ink');
            const text = `${list.length} ${this.potential && index ? `of index ${index}` : name}`;
            context.fillText(text, 18, y + 15.5);
            if (this.potential && index && width > 300) {
                const end = 18 + context.measureText(text).width;
                context.fillStyle = colour('soft');
                context.fillText(`: unstable in ${['', 'one direction', 'two directions', 'three directions', 'four directions', 'five directions'][index] ?? `${index} directions`}`, end, y + 15.5);
            }
            y += heading;
            const columns = Math.max(1, Math.floor(width / w));
            list.forEach((equilibrium, k) => {
                const cell = {x: (k % columns) * w, y: y + Math.floor(k / columns) * s, w, h: s, equilibrium};
                this.cells.push(cell);
                const box = [cell.x + inset, cell.y + inset, w - 2 * inset, s - 2 * inset], age = (now - equilibrium.born) / flash;
                context.fillStyle = colour(stable ? 'stable-panel' : 'cell');
                context.beginPath();
                context.roundRect(...box, Math.min(6, s / 8));
                context.fill();
                const picked = equilibrium.id === this.hover || equilibrium.id === this.pinned;
                if (picked || stable) {
                    context.strokeStyle = picked ? colour('ink') : stroke;
                    context.lineWidth = picked ? 2 : s > 24 ? 1.2 : 0.6;
                    context.stroke();
                }
                if (equilibrium.id === this.followed && s > 60) {
                    context.fillStyle = colour('ink');
                    context.font = '600 12px system-ui, sans-serif';
                    context.fillText('here', box[0] + 7, box[1] + 17);
                }
                const pad = s * 0.02;
                draw_sketch(context, this.sketch(equilibrium.q), this.extent, [box[0] + pad, box[1] + pad, box[2] - 2 * pad, box[3] - 2 * pad], {stroke, stable});
                if (age < 1 && !this.still.matches) {
                    lively = true;
                    context.strokeStyle = colour('born');
                    context.globalAlpha = 1 - age;
                    context.lineWidth = 4;
                    context.beginPath();
                    context.roundRect(...box, Math.min(6, s / 8));
                    context.stroke();
                    context.globalAlpha = 1;
                }
            });
            y += Math.ceil(list.length / columns) * s + gap;
        }
        const words = ordered.map(([index, list]) => `${list.length} ${this.potential ? (index ? `of index ${index}` : 'stable') : ''}`).join(', ');
        this.canvas.setAttribute('aria-label', `${counted(this.shown.length, 'equilibrium', 'equilibria')}: ${words}. Arrow keys choose one.`);
        this.fresh = true;
        if (lively && !this.pending) this.#flash();
    }

    // While something flashes all is drawn once a frame; not again where a move has done so since the last one.
    #flash() {
        this.pending = true;
        requestAnimationFrame(() => {
            this.pending = false;
            if (this.fresh) this.#flash();
            else this.draw();
            this.fresh = false;
        });
    }
}
