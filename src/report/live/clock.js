// How long a method takes on this GPU: by timer queries where the browser's are sound, else by many frames in
// a row.

/// Software that draws for a GPU: its timer queries time nothing.
const SOFTWARE = /swiftshader|llvmpipe|lavapipe|software|basic render/i;

const middle = values => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
const nextFrame = () => new Promise(resolve => setTimeout(resolve, 4));

class Clock {
    constructor(renderer) {
        this.renderer = renderer;
        const {gl} = renderer;
        const queries = gl.getExtension('EXT_disjoint_timer_query_webgl2');
        const isSound = queries && !SOFTWARE.test(renderer.name) &&
            gl.getQuery(queries.TIME_ELAPSED_EXT, queries.QUERY_COUNTER_BITS_EXT) > 0;
        this.queries = isSound ? queries : null;
        this.words = isSound ? 'by the GPU\'s own timer' : 'by the clock, many frames in a row until a pixel is read back';
    }

    /// Milliseconds a frame of the method's lines; null if the GPU's clock was disturbed.
    async time(name, camera, width, height) {
        const draw = () => this.renderer.drawLines(name, camera, width, height);
        this.renderer.finish(draw()); // the first frame compiles and allocates
        return this.queries ? this.timeByQueries(draw) : this.timeByFrames(draw);
    }

    timeByFrames(draw) {
        const timed = count => {
            const start = performance.now();
            let target = null;
            for (let i = 0; i < count; ++i) target = draw();
            this.renderer.finish(target);
            return (performance.now() - start) / count;
        };
        const count = Math.max(1, Math.min(200, Math.round(80 / timed(1))));
        return middle([0, 1, 2, 3, 4].map(() => timed(count)));
    }

    async timeByQueries(draw) {
        const {gl} = this.renderer;
        const pending = [];
        for (let i = 0; i < 20; ++i) {
            const query = gl.createQuery();
            gl.beginQuery(this.queries.TIME_ELAPSED_EXT, query);
            draw();
            gl.endQuery(this.queries.TIME_ELAPSED_EXT);
            pending.push(query);
        }
        gl.flush();
        for (let waited = 0; !gl.getQueryParameter(pending.at(-1), gl.QUERY_RESULT_AVAILABLE); ++waited) {
            if (waited > 2000) return null;
            await nextFrame();
        }
        if (gl.getParameter(this.queries.GPU_DISJOINT_EXT)) return null;
        const times = pending.map(query => gl.getQueryParameter(query, gl.QUERY_RESULT) / 1e6);
        pending.forEach(query => gl.deleteQuery(query));
        return middle(times);
    }
}
