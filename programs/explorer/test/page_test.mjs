// Opens the built page as a reader does, drags, and compares what it shows with the native program.
//   node page_test.mjs --page index.html --equilibria PROGRAM --modules node_modules [--browser chromium] [--screenshots FOLDER]
// Prints what it measures; the last line is the sum. Status 1 where a check fails.
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, statSync, writeFileSync, mkdtempSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {gzipSync} from 'node:zlib';

const options = {browser: '/usr/bin/chromium'};
for (let i = 2; i < process.argv.length; i += 2) options[process.argv[i].replace(/^--/, '')] = process.argv[i + 1];
const puppeteer = createRequire(join(resolve(options.modules), 'x.js'))('puppeteer-core');
const root = join(dirname(fileURLToPath(import.meta.url)), '../../..'), address = pathToFileURL(resolve(options.page)).href;
const scratch = mkdtempSync(join(tmpdir(), 'explorer-'));

let passed = 0, failed = 0;
function check(truth, what) {
    if (truth) return void ++passed;
    ++failed;
    console.error(`FAILED: ${what}`);
}
const note = text => console.log(text);
const native = (...words) => JSON.parse(execFileSync(options.equilibria, [...words, '--json', '-'], {encoding: 'utf8', maxBuffer: 1e9}));
const sleep = milliseconds => new Promise(done => setTimeout(done, milliseconds));
const chain_model = (model, name) => {
    const file = join(scratch, `${name}.json`);
    writeFileSync(file, JSON.stringify(model));
    return file;
};

const browser = await puppeteer.launch({executablePath: options.browser, args: ['--no-sandbox'], headless: true});
try {
    const page = await browser.newPage(), errors = [];
    page.on('console', message => message.type() === 'error' && errors.push(message.text()));
    page.on('pageerror', error => errors.push(error.stack ?? error.message));
    page.on('request', request => /^https?:/.test(request.url()) && errors.push(`asked for ${request.url()}`));
    const until = (condition, what, seconds = 60) => page.waitForFunction(condition, {timeout: seconds * 1000, polling: 30}).catch(() => check(false, `${what} within ${seconds} s`));
    const open = async (hash = '', width = 1440, height = 1000, scheme = 'light') => {
        await page.goto('about:blank');
        await page.setViewport({width, height, isMobile: width < 500, hasTouch: width < 500});
        await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: scheme}]);
        await page.goto(address + hash);
        await until('window.explorer && explorer.times.first !== null', `the first picture of ${hash || 'the page'}`);
    };
    const traced = () => until('explorer.locus && explorer.diagram && explorer.proof', 'curves, line and proof');

    // Size and first picture.
    const bytes = readFileSync(options.page), packed = gzipSync(bytes, {level: 9}).length;
    note(`index.html: ${(statSync(options.page).size / 1e6).toFixed(2)} MB, ${(packed / 1e6).toFixed(2)} MB compressed`);
    check(packed < 2e6, 'the page is under 2 MB compressed');
    await open();
    const first = await page.evaluate(() => explorer.times.first);
    note(`first picture: ${first.toFixed(0)} ms`);
    check(first < 2000, 'the first picture is there within 2 s');
    await traced();
    note(`locus of two links: ${(await page.evaluate(() => explorer.times.locus)).toFixed(0)} ms`);

    // The cusp of Figure 3.2, to ten digits.
    const model = join(root, 'examples/models/rotating_double_pendulum.json');
    const theirs = native('locus', model, '--x', 'alpha=0:1', '--y', 'omega=0:5'), ours = await page.evaluate(() => explorer.locus);
    const cusp = locus => locus.cusps.find(c => c.alpha > 0.1);
    for (const name of ['alpha', 'omega'])
        check(Math.abs(cusp(ours)[name] / cusp(theirs)[name] - 1) < 1e-10, `the cusp's ${name}: ${cusp(ours)[name]} and ${cusp(theirs)[name]}`);
    check(JSON.stringify(ours.regions.map(r => r.by_index)) === JSON.stringify(theirs.regions.map(r => r.by_index)), 'the regions by index');
    check(ours.evidence.complete, 'no curve is missing');
    check((await page.$eval('#proof', e => e.textContent)).includes('Proved: these 12 are all'), 'the proof is told');

    // Fifty points: the point dragged there shows what the native program counts.
    const file = chain_model(await page.evaluate(() => explorer.model), 'two_links');
    let random = 7;
    const uniform = () => (random = (random * 48271) % 2147483647) / 2147483647;
    let agree = 0;
    for (let k = 0; k < 50; ++k) {
        const at = [0.01 + 0.98 * uniform(), 0.05 + 4.9 * uniform()];
        const shown = await page.evaluate(async at => {
            explorer.move_to(at, performance.now());
            for (let tries = 0; tries < 2000; ++tries) {
                if (explorer.solution?.at?.alpha === at[0] && explorer.solution.at.omega === at[1]) return explorer.solution.by_index;
                await new Promise(done => setTimeout(done, 2));
            }
            return null;
        }, at);
        const expected = native('solve', file, '--set', `alpha=${at[0]},omega=${at[1]}`).by_index;
        if (JSON.stringify(shown) === JSON.stringify(expected)) ++agree;
        else console.error(`at ${at}: ${JSON.stringify(shown)} and ${JSON.stringify(expected)}`);
    }
    note(`counts by index: ${agree} of 50 points agree with the native program`);
    check(agree === 50, 'counts by index at 50 points');

    // Dragging by mouse: an equilibrium is born, and how late the picture is.
    const drag = async (what, bound) => {
        const box = await (await page.$('#plane svg')).boundingBox();
        await page.evaluate(() => (explorer.times.drag.length = 0));
        await page.mouse.move(box.x + 100, box.y + 0.85 * box.height);
        await page.mouse.down();
        for (let i = 1; i <= 60; ++i) {
            await page.mouse.move(box.x + 100 + 4 * i, box.y + 0.85 * box.height - (0.75 * box.height * i) / 60);
            await sleep(16);
        }
        await page.mouse.up();
        await sleep(300);
        const all = await page.evaluate(() => explorer.times.drag), of = key => all.map(t => t[key]).sort((a, b) => a - b);
        const median = key => of(key)[all.length >> 1], late = key => of(key)[Math.floor(0.9 * all.length)];
        note(`${what}: ${all.length} moves; from the page's hearing of a move to its picture ${median('handled').toFixed(1)} ms (nine of ten within ${late('handled').toFixed(1)} ms), `
            + `from the mouse ${median('total').toFixed(1)} ms (${late('total').toFixed(1)} ms), engine ${median('engine').toFixed(1)} ms`);
        check(all.length > 20, `${what}: the point follows`);
        check(median('handled') < bound, `${what}: half of the moves are drawn within ${bound} ms`);
    };
    await sleep(1600);
    const before = await page.evaluate(() => explorer.solution.real);
    await drag('dragging, two links', 16);
    check((await page.evaluate(() => explorer.solution.real)) !== before, 'dragging changes the number of equilibria');

    // Keys.
    const omega = await page.evaluate(() => explorer.state.parameters.omega);
    await page.$eval('.handle', e => e.focus());
    await page.keyboard.press('ArrowDown');
    check((await page.evaluate(() => explorer.state.parameters.omega)) < omega, 'an arrow key moves the point');

    // A finger on a phone; names of all that can be used.
    await open('', 390, 844);
    await traced();
    const plane = await (await page.$('#plane svg')).boundingBox(), count = await page.evaluate(() => explorer.solution.real);
    await page.touchscreen.touchStart(plane.x + 160, plane.y + 200);
    for (let i = 1; i <= 20; ++i) {
        await page.touchscreen.touchMove(plane.x + 160, plane.y + 200 - 6 * i);
        await sleep(20);
    }
    await page.touchscreen.touchEnd();
    await sleep(300);
    check((await page.evaluate(() => explorer.solution.real)) !== count, 'a finger drags the point');
    check(/^born: /.test(await page.$eval('#change', e => e.textContent)), 'births are told');
    const unnamed = [], visit = part => {
        if (['button', 'slider', 'radio', 'tab', 'combobox', 'image', 'img', 'spinbutton', 'textbox'].includes(part.role) && !part.name) unnamed.push(part.role);
        part.children?.forEach(visit);
    };
    visit(await page.accessibility.snapshot());
    check(unnamed.length === 0, `every control has a name: ${unnamed}`);

    // What is saved reads back.
    await open('#chain&links=2&p.alpha=0.3&p.omega=2.5&line=alpha');
    await traced();
    const [, , table] = await page.evaluate(() => explorer.saved('equilibria-csv')), lines = table.trim().split('\n').map(l => l.split(','));
    const here = native('solve', file, '--set', 'alpha=0.3,omega=2.5');
    check(lines[0].join() === 'q1,q2,index,nullity,multiplicity,stable,energy,residual,condition,margin,path', 'the columns of the CSV');
    check(lines.length === here.real + 1, 'a line of the CSV for each equilibrium');
    check(here.equilibria.every((e, k) => e.angles.every((q, i) => Math.abs(Number(lines[k + 1][i]) - q) < 1e-12)), 'the angles of the CSV are the native ones');
    const [, , curves] = await page.evaluate(() => explorer.saved('curves-csv'));
    check(/^curve,kind,alpha,omega\n0,(fold|pitchfork),/.test(curves), 'the curves as CSV');
    const saved = JSON.parse((await page.evaluate(() => explorer.saved('json')))[2]);
    check(saved.solution.real === here.real && saved.solution.proof.complete && saved.locus.cusps.length === 2, 'the JSON reads back');
    const [, , picture] = await page.evaluate(() => explorer.saved('plane-svg'));
    check(await page.evaluate(text => !new DOMParser().parseFromString(text, 'image/svg+xml').querySelector('parsererror'), picture), 'the SVG is well formed');
    check((await page.evaluate(() => explorer.state.line)) === 'alpha', 'the address holds the line');

    // A view is shared by its address.
    const hash = await page.evaluate(() => location.hash);
    await open(hash);
    await until('explorer.solution', 'the shared view');
    check((await page.evaluate(() => explorer.solution.real)) === here.real, 'a shared address shows the same');

    // Models of one's own, and wrong ones.
    await open('#own');
    const text = await page.$eval('#text', e => e.value);
    const write = async (changed, wait = 'document.querySelector("#text-error").textContent') => {
        await page.$eval('#text', (e, t) => { e.value = t; e.dispatchEvent(new Event('input')); }, changed);
        await until(wait, 'the answer to a changed model', 20);
        return page.$eval('#text-error', e => e.textContent);
    };
    const message = await write(text.replace('cos(t2)', 't2*cos(t2)'));
    check(/potential, line 1, column 15\b.*an angle/.test(message), `a wrong formula's message: ${message}`);
    await page.click('#text-error button');
    check((await page.$eval('#text', e => e.value.slice(e.selectionStart - 2, e.selectionStart + 1))) === 't2*', 'the place of the mistake is shown');
    check(/line 4, column 3/.test(await write(text.replace('["t1", "t2"],', '["t1", "t2"]'), 'document.querySelector("#text-error").textContent.includes("JSON")')), 'what is no JSON has line and column');
    const fine = await write(text.replace('"offset": 0.2', '"offset": 0.3'), '!document.querySelector("#text-error").textContent && explorer.solution?.at?.offset === 0.3');
    check(fine === '', 'a right model has no message');

    // The other tabs.
    await open('#mechanism');
    await traced();
    const mechanism = await page.evaluate(() => [explorer.locus.cusps.length, explorer.locus.regions.length]);
    check(mechanism[0] === 10 && mechanism[1] === 6, `the mechanism's plane has 10 cusps and 6 regions: ${mechanism}`);
    await page.click('#motion-go');
    await until('/t = [\\d.]+ s/.test(document.querySelector("#motion-status").textContent)', 'the motion plays', 30);
    await open('#body');
    await until('explorer.locus && explorer.diagram && explorer.proof', 'curves, branches and proof of the body with a beam', 120);
    note(`body with a beam: curves of the plane ${(await page.evaluate(() => explorer.times.locus)).toFixed(0)} ms`);
    const beam = JSON.parse(execFileSync(join(dirname(options.equilibria), 'body_beam'), ['--modes', '1', '--momentum', '6', '--json', '-'], {encoding: 'utf8'}));
    check((await page.evaluate(() => explorer.solution.real)) === beam.equilibria.length, 'the body has as many equilibria as the native program finds');
    check(/^Proved: these 7 are there/.test((await page.$eval('#proof', e => e.textContent)).replace('✓ ', '')), 'the proof says what is proved of the body');
    const whirl = 0.8 * beam.whirl_speeds[0][0], forks = await page.evaluate(() => explorer.diagram.events.map(e => e.momentum));
    check(forks.some(momentum => Math.abs(momentum / whirl - 1) < 1e-10), 'the spin about the beam begins to whirl where the native program says');
    await page.click('#motion-go');
    await until('/t = [\\d.]+ units/.test(document.querySelector("#motion-status").textContent)', 'the motion of the body plays', 30);
    await until('!document.querySelector("#locus-stop") || document.querySelector("#locus-stop").hidden', 'the counts of the body', 180);
    check((await page.$$eval('#plane .labels .count', all => all.length)) > 3, 'regions of the body are labelled');
    await open('#zeeman');
    await traced();
    check((await page.evaluate(() => explorer.locus.cusps.length)) === 4, 'Zeeman’s diamond has four cusps');

    // Structures in space: a critical point is clicked.
    await page.goto('about:blank');
    await page.goto(address + '#structures');
    await until('/branches and \\d+ critical points/.test(document.querySelector("#structures .status")?.textContent)', 'the branches of the dome');
    note(`structures: ${await page.$eval('#structures .status', e => e.textContent)}`);
    await page.$eval('#structures .critical:last-of-type', e => e.dispatchEvent(new MouseEvent('click', {bubbles: true})));
    check(/^(fold|pitchfork|multiple).*critical$/.test(await page.$eval('#structures .now', e => e.textContent)), 'a critical point is told');
    check((await page.$eval('#space canvas', e => e.toDataURL().length)) > 5000, 'the dome is drawn in space');

    // Four links: counted at points, and fast enough to drag.
    await open('#chain&links=4');
    await until('explorer.proof', 'the proof of four links');
    check((await page.evaluate(() => explorer.proof.bound)) === 256, 'four links: 256 solutions');
    await until('!document.querySelector("#locus-trace").hidden', 'the counts of four links', 180);
    await drag('dragging, four links', 100);

    // Pictures, and no page wider than its window.
    if (options.screenshots) mkdirSync(options.screenshots, {recursive: true});
    for (const [view, hash] of [['chain', '#chain&links=2&p.alpha=0.3&p.omega=2.4'], ['mechanism', '#mechanism'], ['body', '#body'], ['zeeman', '#zeeman'], ['own', '#own'], ['structures', '#structures']])
        for (const [width, height] of [[1440, 1000], [820, 1180], [390, 844]])
            for (const scheme of ['light', 'dark']) {
                if (scheme === 'dark' && view !== 'chain' && width !== 1440) continue;
                if (view === 'structures') {
                    await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: scheme}]);
                    await page.setViewport({width, height, isMobile: width < 500, hasTouch: width < 500});
                    await page.goto('about:blank');
                    await page.goto(address + hash);
                    await until('/traced/.test(document.querySelector("#structures .status")?.textContent)', 'the branches of the dome');
                } else {
                    await open(hash, width, height, scheme);
                    await traced();
                }
                await sleep(300);
                check(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${view} fits into ${width} pixels`);
                if (options.screenshots) await page.screenshot({path: join(options.screenshots, `${view}_${width}_${scheme}.png`), fullPage: true});
            }
    for (const error of errors) console.error(`console: ${error}`);
    check(errors.length === 0, 'no error in the console, no request');
} finally {
    await browser.close();
}
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
