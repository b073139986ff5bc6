// Makes the page of its modules: one index.html with styles, scripts, workers and the engine inside.
//   node bundle.mjs --engine engine.wasm --modules node_modules --out FOLDER
import {readFileSync, writeFileSync, mkdirSync, existsSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {deflateRawSync, gzipSync} from 'node:zlib';

const options = {};
for (let i = 2; i < process.argv.length; i += 2) options[process.argv[i].replace(/^--/, '')] = process.argv[i + 1];
for (const name of ['engine', 'modules', 'out'])
    if (!options[name]) {
        console.error(`error: bundle.mjs needs --${name}`);
        process.exit(2);
    }
const page = join(dirname(fileURLToPath(import.meta.url)), 'page'), modules = resolve(options.modules);
const esbuild = createRequire(join(modules, 'x.js'))('esbuild');
const common = {bundle: true, minify: true, write: false, target: 'es2022', charset: 'utf8', nodePaths: [modules], logLevel: 'warning', legalComments: 'none'};

async function bundled(entry, plugins = []) {
    const built = await esbuild.build({...common, entryPoints: [join(page, entry)], format: 'iife', plugins});
    return built.outputFiles[0].text;
}
const worker = await bundled('worker.js');
const inline_worker = {
    name: 'inline worker',
    setup(build) {
        build.onResolve({filter: /^inline:worker$/}, () => ({path: 'worker', namespace: 'inline'}));
        build.onLoad({filter: /.*/, namespace: 'inline'}, () => ({contents: worker, loader: 'text'}));
    },
};
const safe = script => script.replaceAll('</script', '<\\/script');
const main = safe(await bundled('main.js', [inline_worker]));
const structures = existsSync(join(page, 'structures.js')) ? safe(await bundled('structures.js')) : '';
const style = (await esbuild.build({...common, entryPoints: [join(page, 'style.css')]})).outputFiles[0].text;
const engine = deflateRawSync(readFileSync(options.engine), {level: 9});

const scripts = [
    `<script id="engine" type="application/octet-stream">${engine.toString('base64')}</script>`,
    structures && `<script id="structures-script" type="text/plain">${structures}</script>`,
    `<script>${main}</script>`,
].filter(Boolean).join('\n');
const html = readFileSync(join(page, 'index.html'), 'utf8').replace('<!-- style -->', () => `<style>${style}</style>`).replace('<!-- scripts -->', () => scripts);
mkdirSync(options.out, {recursive: true});
writeFileSync(join(options.out, 'index.html'), html);
const megabytes = bytes => (bytes / 1e6).toFixed(2);
console.log(`index.html: ${megabytes(html.length)} MB, ${megabytes(gzipSync(html, {level: 9}).length)} MB compressed; engine ${megabytes(engine.length)} MB, page ${megabytes(main.length)} MB${structures ? `, three.js ${megabytes(structures.length)} MB` : ''}`);
