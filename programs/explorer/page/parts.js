// What the modules of the page share beside what is shown: three engines, the panels that main.js makes, and times for tests.
//   live: the equilibria at the point; calm: what is asked once the point rests (proof, line); slow: curves of the plane.
import {Engine} from './engine.js';

export const $ = selector => document.querySelector(selector);
export const put = (element, text) => void (element.textContent !== text && (element.textContent = text));  // the same again would be laid out again
export const live = new Engine(), calm = new Engine(), slow = new Engine();
export const engines = [live, calm, slow];
export const panels = {};
export const times = {first: null, drag: [], locus: null};
