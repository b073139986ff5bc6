// A motion from rest, played back. What a case says of its own, as `motion`, all but the first two optional:
//   until, speed: seconds of the motion, how many times as fast it is shown; start: the unknowns at the start, for the default of sliders
//   sliders: [name, label, low, high, value] each: a parameter of the model of that name is set, anything else is asked for as the start
//   place(values): the unknowns at the start, for the picture, of the sliders' values by name; away(q, e): how far q is from an equilibrium
//   ghost(sketch): what of it is drawn for the moments before; unit: of time
import {draw_sketch} from './shapes.js';
import {colour, index_colour} from './colours.js';
import {slider} from './sliders.js';
import {short, written} from './names.js';
import {watched_size} from './size.js';

const defaults = {
    unit: 's',
    place: values => Object.values(values),
    away: (q, e) => Math.hypot(...e.q.map((v, i) => Math.sin((v - q[i]) / 2) * 2)),
    ghost: sketch => ({...sketch, ground: null, dashes: [], thin: [], arrows: [], pivots: []}),
};
const unknowns_as_sliders = ({motion, unknowns, labels}) => unknowns.map((name, i) => [name, `${written(name, labels)} at the start [rad]`, -Math.PI, Math.PI, motion.start[i]]);

export class Motion {
    constructor(root, engine) {
        this.root = root;
        this.engine = engine;
        this.canvas = root.querySelector('canvas');
        this.button = root.querySelector('#motion-go');
        this.status = root.querySelector('#motion-status');
        this.button.addEventListener('click', () => (this.playing ? this.stop() : this.go()));
        this.size = watched_size(this.canvas, () => this.draw());
        addEventListener('colours', () => this.draw());
    }

    // The mechanism as it is let go: {model, set, unknowns, labels, motion, sketch, extent, equilibria}.
    show(what) {
        const fresh = this.what?.model !== what.model;
        this.what = {...what, motion: {...defaults, ...what.motion}};
        if (fresh) this.#build_sliders(what.motion.sliders ?? unknowns_as_sliders(what));
        if (!this.playing) {
            this.points = null;
            this.draw();
        }
    }

    #build_sliders(sliders) {
        this.stop();
        this.status.textContent = '';
        this.values = Object.fromEntries(sliders.map(([name, , , , value]) => [name, value]));
        this.root.querySelector('#motion-sliders').replaceChildren(...sliders.map(([name, label, low, high, value]) => slider({
            name: `start-${name}`, label, low, high, value,
            changed: value => {
                this.stop();
                this.values[name] = value;
                this.points = null;
                this.status.textContent = '';
                this.draw();
            },
        })));
    }

    async go() {
        const {model, set: parameters, motion} = this.what, set = {...parameters}, start = {};
        for (const [name, value] of Object.entries(this.values)) (name in set ? set : start)[name] = value;
        this.status.textContent = 'computing the motion …';
        try {
            const {response} = await this.engine.run({command: 'motion', model, set, start, rates: {}, until: motion.until, points: motion.until * 30}, {full: true});
            if (model !== this.what.model) return;
            this.points = response.points;
            this.balance = response.largest_balance;
            this.response = response;
        } catch (error) {
            if (error.message && model === this.what.model) this.status.textContent = error.message;
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
        const {q, t} = this.points.at(-1), {motion} = this.what, away = e => motion.away(q, e);
        const nearest = [...this.what.equilibria].sort((a, b) => away(a) - away(b))[0];
        this.draw();
        const near = nearest && away(nearest) < 0.12 ? `at rest, or nearly, in the ${nearest.index === 0 ? 'stable equilibrium' : `equilibrium of index ${nearest.index}`}` : 'still swinging';
        this.status.textContent = `After ${short(t, 3)} ${motion.unit}: ${near}. Energy is balanced to ${short(this.balance, 2)} of itself.`;
    }

    draw() {
        const {width, height} = this.size(), ratio = devicePixelRatio || 1;
        if (!width || !this.what) return;
        this.canvas.width = width * ratio;
        this.canvas.height = height * ratio;
        const context = this.canvas.getContext('2d'), {sketch, extent, motion} = this.what, box = [6, 6, width - 12, height - 12];
        context.scale(ratio, ratio);
        for (const e of this.what.equilibria.filter(e => e.index === 0))
            draw_sketch(context, sketch(e.q), extent, box, {stroke: index_colour(0), stable: false, faint: 0.35});
        if (this.points && this.at)
            for (let k = 12; k >= 1; --k) {
                const p = this.points[this.at - 3 * k];
                if (p) draw_sketch(context, motion.ghost(sketch(p.q)), extent, box, {stroke: colour('born'), stable: false, faint: 0.16 * (1 - k / 13)});
            }
        const point = this.points?.[this.playing || this.at ? this.at : 0];
        draw_sketch(context, sketch(point?.q ?? motion.place(this.values)), extent, box, {stroke: colour('born'), stable: true});
        if (point && this.playing) this.status.textContent = `t = ${point.t.toFixed(1)} ${motion.unit}, shown ${motion.speed} times as fast`;
    }
}
