// Images of views, as pixel codes: what the page shows of them is coloured here.
//
// A truth holds the class of each pixel (0 none, 1 contour, ..., 7 does not count). A method's image
// holds 0 paper, 1 does not count, 2 a right pixel, and 3 + cause for a wrong one. Beside it may be the
// share of each pixel that is ink, 0..255.

const FIRST_WRONG = 3;
const FIRST_MISSING = FIRST_WRONG + CAUSES.findIndex(cause => cause.kind === 'false_negatives');

class ViewImages {
    constructor(packed) {
        this.packed = packed; // per run: {"scene\nview": {width, height, methods, truth, images, inks}}, or beside: the script with the last three
        this.decoded = new Map();
        this.lostViews = 0;
    }

    /// What the page needs beside itself.
    placeWords() {
        const beside = this.packed.flatMap(Object.values).filter(entry => entry.beside).length;
        return `This page needs no network, and ${beside ? `for the images of ${count(beside, 'view')} the folder images of its run` : 'no other file'}.`;
    }

    /// The truth and the images of a view's entry; of one beside the page they are loaded, by a script:
    /// a page that is a file may read no pixels of other files. null where the script is missing.
    load(entry) {
        if (!entry.beside) return entry;
        entry.loaded ??= new Promise(resolve => {
            const script = element('script', {src: encodeURI(entry.beside).replace(/[#?]/g, encodeURIComponent),
                onload: () => resolve(script.images), onerror: () => resolve(null)});
            document.head.append(script);
        });
        return entry.loaded;
    }

    /// Why there is no image of a view.
    missingWords() {
        return this.lostViews ? `The images of ${count(this.lostViews, 'view')} are in the folder images of the run, which is not beside this page.`
            : 'The run folder has no image of this view (--images all keeps every view’s).';
    }

    /// Leaves the page the images that it holds: what lies beside it elsewhere is not here.
    loseBeside() {
        for (const ofRun of this.packed) {
            for (const [key, entry] of Object.entries(ofRun).filter(([, entry]) => entry.beside)) {
                delete ofRun[key];
                ++this.lostViews;
            }
        }
        redraw(['look']);
    }

    /// What there is of a view of a run; null if the run folder has no images of it.
    entry(run, scene, view) {
        const ofRun = this.packed[run.index];
        return (ofRun && ofRun[`${scene}\n${view}`]) || null;
    }

    has(run, scene, view, method) {
        const entry = this.entry(run, scene, view);
        return Boolean(entry && (method === 'truth' || method === 'oracle' || method in entry.methods));
    }

    /// The codes of a truth ('truth') or of a method's image: a promise of {width, height, codes,
    /// isTruth, ink}, or of null.
    async codes(run, scene, view, method) {
        const entry = this.entry(run, scene, view);
        if (!entry) return null;
        const isTruth = method === 'truth' || method === 'oracle';
        const loaded = await this.load(entry);
        if (!loaded && this.entry(run, scene, view)) this.loseBeside();
        const index = entry.methods[method];
        const data = loaded && (isTruth ? loaded.truth : loaded.images[index]);
        if (!data) return null;
        const key = [run.index, scene, view, isTruth ? 'truth' : method].join('\n');
        if (!this.decoded.has(key)) {
            if (this.decoded.size > 80) this.decoded.delete(this.decoded.keys().next().value);
            this.decoded.set(key, decodeCodes(data, isTruth, !isTruth && loaded.inks[index]));
        }
        return this.decoded.get(key);
    }
}

async function decodeCodes(data, isTruth, ink) {
    const [image, shares] = await Promise.all([data, ink].map(png => png && decodeGrey(png)));
    return {width: image.width, height: image.height, codes: image.bytes, isTruth, ink: shares && shares.bytes};
}

async function decodeGrey(data) {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const [width, height] = [image.naturalWidth, image.naturalHeight];
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext('2d', {willReadFrequently: true});
    context.drawImage(image, 0, 0);
    const pixels = context.getImageData(0, 0, width, height).data;
    return {width, height, bytes: Uint8Array.from({length: width * height}, (_, i) => pixels[4 * i])};
}

/// How much a code matters where several pixels become one: errors over lines over paper; of classes
/// the lower one.
function weightOf(code, isTruth) {
    if (isTruth) return code === 0 ? 0 : code === 7 ? 1 : 20 - code;
    return code;
}

/// The image at 1/factor of its size: each pixel is the one of its block that matters most, so that
/// thin lines and rare errors survive.
function shrinkCodes(image, factor) {
    if (factor <= 1) return image;
    const width = Math.ceil(image.width / factor);
    const height = Math.ceil(image.height / factor);
    const codes = new Uint8Array(width * height);
    const weights = Uint8Array.from({length: 256}, (_, code) => weightOf(code, image.isTruth));
    for (let y = 0; y < image.height; ++y) {
        const to = Math.floor(y / factor) * width;
        for (let x = 0; x < image.width; ++x) {
            const code = image.codes[y * image.width + x];
            if (code === 0) continue;
            const at = to + Math.floor(x / factor);
            if (weights[code] > weights[codes[at]]) codes[at] = code;
        }
    }
    return {width, height, codes, isTruth: image.isTruth};
}

/// Lines one pixel wider, to be seen where the image is shown smaller than it is.
function thickenCodes(image) {
    const {width, height} = image;
    const codes = image.codes.slice();
    const spread = (from, to) => {
        const code = image.codes[from];
        const isLine = image.isTruth ? code > 0 && code < 7 : code >= FIRST_MISSING;
        if (isLine && codes[to] <= 1) codes[to] = code;
    };
    for (let y = 0; y < height; ++y) {
        for (let x = 0; x < width; ++x) {
            const at = y * width + x;
            if (x + 1 < width) spread(at, at + 1);
            if (y + 1 < height) spread(at, at + width);
        }
    }
    return {...image, codes};
}

/// The colour of every code. `look` is 'errors' (missing, false), 'causes' or 'drawn'.
function colourTable(isTruth, look) {
    if (isTruth) return look === 'drawn' ? LABEL_RGB.map((rgb, i) => (i === 0 || i === 7 ? [255, 255, 255] : LABEL_RGB[1])) : LABEL_RGB;
    const ink = LABEL_RGB[1];
    const paper = LABEL_RGB[0];
    const wrong = CAUSES.map(cause => {
        const isFalse = cause.kind === 'false_positives';
        if (look === 'drawn') return isFalse ? ink : paper;
        if (look === 'causes') return cause.rgb;
        return isFalse ? FALSE_RGB : MISSING_RGB;
    });
    return [paper, look === 'drawn' ? paper : IGNORED_RGB, ink, ...wrong];
}

/// The colour of every share of ink on paper, mixed in linear light as src/shade/lay_ink.cpp does.
function inkTable() {
    const light = value => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
    const value = of => (of <= 0.0031308 ? 12.92 * of : 1.055 * of ** (1 / 2.4) - 0.055);
    const [paper, ink] = LABEL_RGB.map(rgb => rgb.map(part => light(part / 255)));
    return Array.from({length: 256}, (_, share) =>
        paper.map((under, part) => Math.round(255 * value(under + (share / 255) * (ink[part] - under)))));
}

function packedColours(table) {
    return Uint32Array.from(table, ([r, g, b]) => (255 << 24) | (b << 16) | (g << 8) | r);
}

/// The codes in colour, on a canvas of the image's size. Ink is grey wherever no code says more.
function paintCodes(image, look) {
    const packed = packedColours(colourTable(image.isTruth, look));
    const grey = image.ink && packedColours(inkTable());
    const isGrey = packed.map((_, code) => image.ink && (look === 'drawn' || code === 0 || code === FIRST_WRONG - 1));
    const pixels = new ImageData(image.width, image.height);
    const words = new Uint32Array(pixels.data.buffer);
    for (let i = 0; i < words.length; ++i)
        words[i] = isGrey[image.codes[i]] ? grey[image.ink[i]] : packed[image.codes[i]];
    const canvas = new OffscreenCanvas(image.width, image.height);
    canvas.getContext('2d').putImageData(pixels, 0, 0);
    return canvas;
}

/// Draws a method's image, or the truth, into `canvas` so that it fills `width_px` of the page.
async function drawThumb(canvas, run, scene, view, method, width_px, look = 'errors') {
    const image = await viewImages.codes(run, scene, view, method);
    if (!image) return false;
    const dense = Math.min(2, window.devicePixelRatio || 1);
    const factor = Math.max(1, Math.round(image.width / (width_px * dense)));
    image.shrunk ??= {};  // by factor: filters draw the same thumbnails anew
    const shown = factor > 1 ? image.shrunk[factor] ??= shrinkCodes(image, factor) : image;
    canvas.width = shown.width;
    canvas.height = shown.height;
    canvas.style.width = `${width_px}px`;
    canvas.style.height = `${(width_px * shown.height) / shown.width}px`;
    canvas.getContext('2d').drawImage(paintCodes(shown, look), 0, 0);
    return true;
}

/// What the colours of images mean.
function imageLegend(look) {
    const entry = (rgb, text) => element('li', {}, element('i', {style: `background:${rgbText(rgb)}`}), text);
    const items = [element('li', {}, 'Drawn:'), entry(LABEL_RGB[1], 'right')];
    if (look === 'causes') items.push(...CAUSES.map(cause => entry(cause.rgb, cause.text)));
    else items.push(entry(MISSING_RGB, 'missing'), entry(FALSE_RGB, 'false'));
    items.push(entry(IGNORED_RGB, 'does not count'));
    return element('ul', {class: 'legend'}, items);
}

function truthLegend() {
    return element('ul', {class: 'legend'}, element('li', {}, 'Truth:'), CLASSES.map((name, index) => element('li', {},
        element('i', {style: `background:${rgbText(LABEL_RGB[index + 1])}`}), name)));
}
