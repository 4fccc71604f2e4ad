// How long the passes of a method take on this GPU, by a ladder: so many of one pass in a row, twice as many, four
// times as many. What each further one adds is its time; what is there but once falls out. A pass of ten
// microseconds can be timed in no other way.

/// Software that draws for a GPU: its timer queries time nothing.
const SOFTWARE = /swiftshader|llvmpipe|lavapipe|software|basic render/i;
const ROUNDS = 5;
const MOST_ROUNDS = 15; // where the spread is large
const MOST_PASSES = 4096;
/// Times whose spread is a larger share are none.
const MOST_SPREAD = 0.15;

const middle = values => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
const nextFrame = () => new Promise(resolve => setTimeout(resolve, 4));

/// The line through [passes, ns]: how much it rises a pass, and the standard error of that.
function lineThrough(points) {
    const mean = of => points.reduce((sum, point) => sum + of(point), 0) / points.length;
    const [x, y] = [mean(([passes]) => passes), mean(([, ns]) => ns)];
    const width = mean(([passes]) => (passes - x) ** 2);
    const slope = mean(([passes, ns]) => (passes - x) * (ns - y)) / width;
    const square = mean(([passes, ns]) => (ns - y - slope * (passes - x)) ** 2);
    return {slope, error: Math.sqrt(square / width / (points.length - 2))};
}

/// The time was read from a clock too coarse for it, or on a machine too busy.
function isCoarse(ns, spread) {
    return !(spread <= MOST_SPREAD * ns);
}

class Clock {
    constructor(renderer) {
        this.renderer = renderer;
        const {gl} = renderer;
        const queries = gl.getExtension('EXT_disjoint_timer_query_webgl2');
        const isSound = queries && !SOFTWARE.test(renderer.name) &&
            gl.getQuery(queries.TIME_ELAPSED_EXT, queries.QUERY_COUNTER_BITS_EXT) > 0;
        this.queries = isSound ? queries : null;
        this.words = isSound ? 'by the GPU\'s own timer' : 'by the clock, many frames in a row until a pixel is read back';
        this.kind = isSound ? 'timer query' : 'frames read back';
        this.leastRise_ns = isSound ? 8e6 : 60e6;
    }

    /// Nanoseconds of the method's lines and of its mesh, with their spreads; null if the GPU's clock was disturbed.
    async time(name, camera, width, height) {
        // What is drawn is kept in turns: a GPU may leave out what it draws over unseen.
        const drawnBy = own => i => own.drawLines(name, camera, width, height, `timed ${i % 2}`);
        const frame = drawnBy(this.renderer);
        const lines = drawnBy(Object.create(this.renderer, {drawMesh: {value() {}}}));
        const mesh = drawnBy(Object.create(this.renderer, {drawPass: {value() {}}}));
        // The first frames compile, allocate, and leave the codes that the lines are drawn from.
        this.renderer.finish([1, 0].map(frame)[1]);
        const ofLines = await this.ladder(lines);
        const ofMesh = ofLines && await this.ladder(mesh);
        return ofMesh && {lines_ns: ofLines.ns, lines_spread_ns: ofLines.spread_ns, mesh_ns: ofMesh.ns, mesh_spread_ns: ofMesh.spread_ns};
    }

    /// The slope over the least time of each rung. Its spread is how far these lie off a line, or the slope of the
    /// middle round off theirs.
    async ladder(pass) {
        const read = passes => this.reading(() => {
            for (let i = 1; i < passes; ++i) pass(i);
            return pass(0);
        });
        const foot = await read(1);
        let most = 4;
        while (most < MOST_PASSES && await read(most) - foot < this.leastRise_ns) most *= 2;
        const rounds = [];
        let found = null;
        while (rounds.length < ROUNDS || (rounds.length < MOST_ROUNDS && isCoarse(found.ns, found.spread_ns))) {
            const rungs = [];
            for (const passes of [most / 4, most / 2, most]) rungs.push([passes, await read(passes)]);
            if (rungs.some(([, ns]) => Number.isNaN(ns))) return null;
            rounds.push(rungs);
            const least = rungs.map(([passes], rung) => [passes, Math.min(...rounds.map(round => round[rung][1]))]);
            const {slope, error} = lineThrough(least);
            const ofMiddle = middle(rounds.map(round => lineThrough(round).slope));
            found = {ns: Math.max(0, slope), spread_ns: Math.max(error, Math.abs(ofMiddle - slope))};
        }
        return found;
    }

    /// Nanoseconds of what is drawn, one reading a frame; NaN if the GPU's clock was disturbed.
    async reading(draw) {
        await nextFrame();
        if (this.queries) return this.byQuery(draw);
        const start = performance.now();
        this.renderer.finish(draw());
        return 1e6 * (performance.now() - start);
    }

    async byQuery(draw) {
        const {gl} = this.renderer;
        const {TIME_ELAPSED_EXT, GPU_DISJOINT_EXT} = this.queries;
        gl.getParameter(GPU_DISJOINT_EXT); // forgets what was before
        const query = gl.createQuery();
        gl.beginQuery(TIME_ELAPSED_EXT, query);
        draw();
        gl.endQuery(TIME_ELAPSED_EXT);
        gl.flush();
        for (let waited = 0; !gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE); ++waited) {
            if (waited > 2000) return NaN;
            await nextFrame();
        }
        const ns = gl.getParameter(GPU_DISJOINT_EXT) ? NaN : gl.getQueryParameter(query, gl.QUERY_RESULT);
        gl.deleteQuery(query);
        return ns;
    }
}
