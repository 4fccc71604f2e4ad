"""What assistive technology needs of the page, checked in it: the faults as texts, none on a good page.

These are the rules of WCAG 2 that this page can break: names of controls, names that hold what is seen
on them, landmarks, headings in order, single ids, and contrast of texts."""

FAULTS = """
const seen = node => node.checkVisibility({opacityProperty: true, visibilityProperty: true});
const told = node => `${node.tagName.toLowerCase()} ${node.id || node.className} "${node.textContent.trim().slice(0, 30)}"`;
const faults = [];
const rule = (name, nodes) => faults.push(...[...nodes].slice(0, 4).map(node => `${name}: ${told(node)}`));
const all = selector => [...document.querySelectorAll(selector)].filter(seen);
const words = text => text.replace(/\\s+/g, ' ').trim().toLowerCase();

const nameOf = node => node.getAttribute('aria-label') || (node.labels && [...node.labels].map(l => l.textContent).join(' ')) || node.textContent;
const controls = all('button, select, input, summary, [tabindex="0"]');
rule('no name', controls.filter(node => !words(nameOf(node)) && !node.querySelector('[aria-label], title')));
rule('the name lacks what is seen', all('button[aria-label]').filter(node => /\\w/.test(node.textContent) &&
    !words(nameOf(node)).includes(words(node.textContent))));
rule('outside all landmarks', [...document.body.children].filter(node => seen(node) && node.textContent.trim() &&
    !node.matches('header, nav, main, footer, script, noscript, style, [role=region], [role=dialog], [role=tooltip]')));

const ids = all('[id]').map(node => node.id);
rule('an id twice', all('[id]').filter(node => ids.filter(id => id === node.id).length > 1));
const heads = all('h1, h2, h3, h4');
rule('a level of heading left out', heads.filter((node, i) => node.tagName[1] - (i ? heads[i - 1].tagName[1] : 0) > 1));
if (all('h1').length !== 1) faults.push(`${all('h1').length} h1`);
rule('no picture of a title', all('[role=img]').filter(node => !nameOf(node).trim()));

// Contrast of texts on what is painted behind them; a dimmed control's does not count.
const canvas = new OffscreenCanvas(1, 1).getContext('2d', {willReadFrequently: true});
const known = new Map();
const rgba = colour => {
    if (!known.has(colour)) {
        canvas.clearRect(0, 0, 1, 1);
        canvas.fillStyle = colour;
        canvas.fillRect(0, 0, 1, 1);
        known.set(colour, canvas.getImageData(0, 0, 1, 1).data);
    }
    return known.get(colour);
};
const light = ([r, g, b]) => [[r, 0.2126], [g, 0.7152], [b, 0.0722]].reduce((sum, [value, share]) => {
    const part = value / 255;
    return sum + share * (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
}, 0);
const behind = node => {
    for (let at = node; at; at = at.parentElement) {
        const colour = rgba(getComputedStyle(at).backgroundColor);
        if (colour[3] === 255) return colour;
    }
    return [255, 255, 255];
};
const isDimmed = node => node.closest('[aria-disabled=true], .too-dear, [aria-pressed=false].family');
rule('too little contrast', all('body *').filter(node => !node.closest('svg, select, noscript') && !isDimmed(node) &&
    [...node.childNodes].some(child => child.nodeType === 3 && child.data.trim()) && (() => {
        const style = getComputedStyle(node);
        const [a, b] = [light(rgba(style.color)), light(behind(node))];
        const isLarge = parseFloat(style.fontSize) >= 24 || (parseFloat(style.fontSize) >= 18.6 && style.fontWeight >= 700);
        return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05) < (isLarge ? 3 : 4.5);
    })()));
return faults;
"""


def faults(browser):
    return browser.execute_script(FAULTS)
