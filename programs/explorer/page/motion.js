// A motion from rest, played back.
import {draw_sketch} from './shapes.js';
import {colour, index_colour} from './colours.js';
import {slider} from './sliders.js';
import {short, written} from './names.js';

export class Motion {
    constructor(root, engine) {
        this.root = root;
        this.engine = engine;
        this.canvas = root.querySelector('canvas');
        this.button = root.querySelector('#motion-go');
        this.status = root.querySelector('#motion-status');
        this.button.addEventListener('click', () => (this.playing ? this.stop() : this.go()));
        new ResizeObserver(() => this.draw()).observe(this.canvas);
        addEventListener('colours', () => this.draw());
    }

    // The mechanism as it is let go: {model, set, unknowns, labels, motion, sketch, extent, equilibria}.
    show(what) {
        const fresh = this.what?.model !== what.model;
        this.what = what;
        if (fresh || !this.start) {
            this.start = [...what.motion.start];
            const host = this.root.querySelector('#motion-sliders');
            host.replaceChildren(...what.unknowns.map((name, i) => slider({
                name: `start-${name}`, label: `${written(name, what.labels)} at the start [rad]`, low: -Math.PI, high: Math.PI, value: this.start[i],
                changed: value => {
                    this.stop();
                    this.start[i] = value;
                    this.points = null;
                    this.status.textContent = '';
                    this.draw();
                },
            })));
        }
        if (!this.playing) {
            this.points = null;
            this.draw();
        }
    }

    async go() {
        const {model, set, unknowns, motion} = this.what, start = Object.fromEntries(unknowns.map((name, i) => [name, this.start[i]]));
        this.status.textContent = 'computing the motion …';
        try {
            const {response} = await this.engine.run({command: 'motion', model, set, start, rates: {}, until: motion.until, points: motion.until * 30}, {full: true});
            this.points = response.points;
            this.balance = response.largest_balance;
            this.response = response;
        } catch (error) {
            if (error.message) this.status.textContent = error.message;
            return;
        }
        this.playing = true;
        this.button.textContent = '■ Stop';
        const began = performance.now(), last = this.points.at(-1).t;
        const frame = () => {
            if (!this.playing) return;
            const t = ((performance.now() - began) / 1000) * this.what.motion.speed;
            this.at = Math.min(this.points.length - 1, Math.floor((t / last) * (this.points.length - 1)));
            this.draw();
            if (t < last) requestAnimationFrame(frame);
            else this.#settled();
        };
        requestAnimationFrame(frame);
    }
    stop() {
        this.playing = false;
        this.button.textContent = '▶ Let it go';
    }
    #settled() {
        this.stop();
        const q = this.points.at(-1).q, away = e => Math.hypot(...e.q.map((v, i) => Math.sin((v - q[i]) / 2) * 2));
        const nearest = [...this.what.equilibria].sort((a, b) => away(a) - away(b))[0];
        this.draw();
        const near = nearest && away(nearest) < 0.12 ? `at rest, or nearly, in the ${nearest.index === 0 ? 'stable equilibrium' : `equilibrium of index ${nearest.index}`}` : 'still swinging';
        this.status.textContent = `After ${short(this.points.at(-1).t, 3)} s: ${near}. Energy is balanced to ${short(this.balance, 2)} of itself.`;
    }

    draw() {
        const {width, height} = this.canvas.getBoundingClientRect(), ratio = devicePixelRatio || 1;
        if (!width || !this.what) return;
        this.canvas.width = width * ratio;
        this.canvas.height = height * ratio;
        const context = this.canvas.getContext('2d'), {sketch, extent} = this.what, box = [6, 6, width - 12, height - 12];
        context.scale(ratio, ratio);
        for (const e of this.what.equilibria.filter(e => e.index === 0))
            draw_sketch(context, sketch(e.q), extent, box, {stroke: index_colour(0), stable: false, faint: 0.35});
        if (this.points && this.at)
            for (let k = 12; k >= 1; --k) {
                const p = this.points[this.at - 3 * k];
                if (p) draw_sketch(context, {...sketch(p.q), ground: null, thin: [], arrows: [], pivots: []}, extent, box, {stroke: colour('born'), stable: false, faint: 0.16 * (1 - k / 13)});
            }
        const point = this.points?.[this.playing || this.at ? this.at : 0];
        draw_sketch(context, sketch(point?.q ?? this.start), extent, box, {stroke: colour('born'), stable: true});
        if (point && this.playing) this.status.textContent = `t = ${point.t.toFixed(1)} s, shown ${this.what.motion.speed} times as fast`;
    }
}
