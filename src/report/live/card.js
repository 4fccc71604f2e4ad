// A card: how long the methods take on this GPU, as JSON that experiments/cards/tabulate reads.

/// Times methods one after the other, each named to `say` before; without those at which the GPU's clock was disturbed.
/// `view` is the camera's name, '' if it has none.
async function measuredCard({methods, camera, view, width, height, say = () => {}}) {
    const clock = new Clock(renderer);
    const found = [];
    for (const method of methods) {
        say(method);
        try {
            const times = await clock.time(method, camera, width, height);
            if (times) found.push({method, ...times});
        } catch (error) {
            showTrouble(error.message);
        }
    }
    return {
        inkbench_card: 1,
        program_version: DATA.version,
        gpu: renderer.name,
        driver: String(renderer.gl.getParameter(renderer.gl.VERSION)),
        browser: navigator.userAgent,
        clock: clock.kind,
        scene: DATA.scene,
        triangle_count: DATA.triangle_count,
        view,
        width_px: width,
        height_px: height,
        methods: found,
    };
}

function cardText(card) {
    return `${JSON.stringify(card, null, 1)}\n`;
}

function millisecondsOf({lines_ns, mesh_ns}) {
    return (lines_ns + mesh_ns) / 1e6;
}

/// Three digits, never as a power of ten.
function digitsOf(ms) {
    return ms.toLocaleString('en', {minimumSignificantDigits: 3, maximumSignificantDigits: 3, useGrouping: false});
}

/// What a card says of methods, in sentences.
function cardWords(card, methods) {
    const timesOf = method => card.methods.find(times => times.method === method);
    const listOf = text => methods.map(method => {
        const times = timesOf(method);
        return times ? text(method, times) : `${method} not measured`;
    }).join(', ');
    const ms = ns => digitsOf(ns / 1e6);
    const coarse = card.methods.filter(times => isCoarse(times.lines_ns, times.lines_spread_ns)).map(({method}) => method);
    return {
        frames: listOf((method, times) => `${method} ${digitsOf(millisecondsOf(times))} ms`),
        lines: listOf((method, times) => `${method} ${ms(times.lines_ns)} ± ${ms(times.lines_spread_ns)} ms`),
        coarse: coarse.length === 0 ? '' : ` The browser's clock is too coarse, or the machine too busy, for the lines of ${coarse.join(', ')}.`,
    };
}
