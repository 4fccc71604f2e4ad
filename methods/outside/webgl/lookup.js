// Draws the lines of surface_lookup, chords or strokes over what a WebGL 2 context shows, whichever engine drew that.

const TABLE_WIDTH = 4096, TILE_PX = 4;  // texels in a row, and sides of marked squares, as the shaders have them
const SIZES = {
    corners: (width, height) => [width + 1, height + 1],
    cells: (width, height) => [width, height],
    ways: (width, height) => [4 * Math.ceil(width / 8), Math.ceil(height / 4)],
};
const rowsOf = texels => Math.ceil(texels / TABLE_WIDTH);

/// The shader of a method, with what it takes from others' files ("//// screen of surface8") in its place.
function wholeShader(method, files) {
    return files[method].replace(/^(\/\/(?:\/\/|--)) (\w+) of (\w+)\n/gm, (_, mark, part, other) => {
        const text = other === method ? files[other] : wholeShader(other, files);
        const begin = text.indexOf(`${mark} ${part}\n`), end = text.indexOf(`\n${mark} `, begin);
        return text.slice(begin, end < 0 ? text.length : end + 1);
    });
}

/// What moves a vertex of a part, four numbers each: by a morph, and below 0 where its weight is; two bones' matrices and
/// weights, each matrix before its weight.
function termsOf({morphs, bones}, vertex, {matrices, weights}) {
    const first = matrices / 16;
    const added = morphs.map((deltas, i) => [...deltas.slice(3 * vertex, 3 * vertex + 3), -1 - weights - i]);
    const moved = bones.flatMap(([joints, shares]) =>
        [0, 1, 2, 3].flatMap(i => [first + joints[4 * vertex + i], shares[4 * vertex + i]]));
    return [...added.filter(([x, y, z]) => x || y || z).flat(), ...bones.length > 0 ? moved : [first, 1, first, 0]];
}

export class LookupLines {
    /// `files`: the texts of pose.glsl, surface8.glsl, surface_lookup.glsl, chords.glsl and strokes.glsl by name. `words`:
    /// the tables, from `inkbench bake --codes surface_lookup`; their `parts` are pairs of a glTF node and a primitive of its
    /// mesh. Throws an Error where nothing draws into textures of floats.
    constructor(gl, method, files, words) {
        if (!gl.getExtension('EXT_color_buffer_float')) throw new Error('Points move by EXT_color_buffer_float, which is not there.');
        this.gl = gl;
        const [faceCount, partCount, pointCount] = words;
        const [faces, parts] = [words.subarray(3, 3 + 8 * faceCount), words.subarray(3 + 8 * faceCount)];
        this.faceCount = faceCount;
        this.pointCount = pointCount;
        this.parts = Array.from({length: partCount}, (_, i) => [parts[2 * i], parts[2 * i + 1]]);
        this.places = parts.subarray(2 * partCount);  // of points part and vertex
        this.atRest = {faces: this.table(gl.RGBA32UI, faces)};
        this.posed = {points: this.target([gl.RGBA32F], TABLE_WIDTH, rowsOf(pointCount), false),
            faces: this.target([gl.RGBA32UI], TABLE_WIDTH, rowsOf(2 * faceCount), false)};
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        this.tables = {faces: this.posed.faces.textures[0], points: this.posed.points.textures[0]};
        const program = this.programsOf(method, files), moving = this.programsOf('pose', files);
        this.moves = ['points', 'faces'].map(name => [name, moving('screen', name)]);
        this.empty = gl.createVertexArray();
        this.mesh = program('vertex', 'fragment');
        this.isInk = method !== 'surface_lookup';
        const linesOfSides = {surface_lookup: gl.R8UI, chords: gl.RGBA16UI, strokes: gl.RGBA32UI}[method];
        const isStrokes = method === 'strokes';
        const step = (section, by, draws, size) => ({program: program(by, section), by, draws, size});
        this.steps = [step('marks', 'screen', {marks: gl.R8UI}, 'corners'), step('sides', 'tiles', {sides: linesOfSides}, 'corners')];
        if (this.isInk) this.steps.push(step('cells', 'tiles', {pieces: gl.RGBA32UI, ...isStrokes && {exits: gl.RGBA32UI}}, 'cells'));
        if (isStrokes) this.steps.push(step('ways', 'screen', {ways: gl.RGBA32UI}, 'ways'), step('thin', 'spread', {thin: gl.RGBA8}, 'cells'));
        this.lines = program('screen', 'lines');
        this.targets = [];
    }

    /// What makes a program of two sections of a shader.
    programsOf(name, files) {
        const [, ...parts] = wholeShader(name, files).split(/^\/\/\/\/ (\w+)\n/m);
        const sections = Object.fromEntries(parts.flatMap((text, i) => i % 2 ? [] : [[text, parts[i + 1]]]));
        return (vertex, fragment) => this.program(sections[vertex], sections[fragment]);
    }

    texture(format, width, height) {
        const {gl} = this;
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
        for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
        gl.bindTexture(gl.TEXTURE_2D, null);
        return texture;
    }

    table(format, numbers) {
        const texture = this.texture(format, TABLE_WIDTH, rowsOf(numbers.length / 4));
        this.fill(texture, numbers);
        return texture;
    }

    fill(texture, numbers) {
        const {gl} = this;
        const [layout, type] = numbers instanceof Float32Array ? [gl.RGBA, gl.FLOAT] : [gl.RGBA_INTEGER, gl.UNSIGNED_INT];
        const rows = rowsOf(numbers.length / 4);
        const whole = new numbers.constructor(4 * TABLE_WIDTH * rows);
        whole.set(numbers);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        for (const [name, value] of [['FLIP_Y_WEBGL', false], ['PREMULTIPLY_ALPHA_WEBGL', false], ['ALIGNMENT', 4]])
            gl.pixelStorei(gl[`UNPACK_${name}`], value);  // engines leave their own
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, TABLE_WIDTH, rows, layout, type, whole);
        gl.bindTexture(gl.TEXTURE_2D, null);
    }

    program(vertex, fragment) {
        const {gl} = this;
        const program = gl.createProgram();
        for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
            const shader = gl.createShader(kind);
            gl.shaderSource(shader, `#version 300 es\n${text}`);
            gl.compileShader(shader);
            gl.attachShader(program, shader);
        }
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
        return program;
    }

    /// Something to draw into, with textures of these formats.
    target(formats, width, height, hasDepth) {
        const {gl} = this;
        const frame = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        const textures = formats.map(format => this.texture(format, width, height));
        textures.forEach((texture, i) =>
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0));
        gl.drawBuffers(formats.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
        const depth = hasDepth ? this.texture(gl.DEPTH_COMPONENT32F, width, height) : null;
        if (depth) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth, 0);
        return {frame, textures, depth, width, height};
    }

    /// Targets of this size; those of another one are let go.
    resize(width, height) {
        const {gl} = this;
        for (const {frame, textures, depth} of this.targets) {
            gl.deleteFramebuffer(frame);
            [...textures, depth].forEach(texture => gl.deleteTexture(texture));
        }
        this.targets = [this.target([gl.R32UI, gl.R32UI], ...SIZES.corners(width, height), true)];
        for (const {draws, size} of this.steps) this.targets.push(this.target(Object.values(draws), ...SIZES[size](width, height), false));
        this.size = [width, height];
    }

    /// Draws vertices without attributes; what `program` does not read of the textures and values is left out.
    run(program, target, textures, values, count, kind = this.gl.TRIANGLES) {
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
        gl.viewport(0, 0, target.width, target.height);
        gl.useProgram(program);
        Object.entries(textures).forEach(([name, texture], unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(gl.TEXTURE_2D, texture);
            gl.uniform1i(gl.getUniformLocation(program, name), unit);
        });
        for (const [name, value] of Object.entries({...values, target_size: [target.width, target.height]})) {
            const place = gl.getUniformLocation(program, name);
            if (value.length === 16) gl.uniformMatrix4fv(place, false, value);
            else if (value.length === 2) gl.uniform2fv(place, value);
            else gl.uniform1f(place, value);
        }
        gl.drawArrays(kind, 0, count);
        // A sampler of an engine that has no texture yet would read these, which are of another kind.
        Object.keys(textures).forEach((_, unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(gl.TEXTURE_2D, null);
        });
    }

    /// Takes, once, the model at rest. Of each part `position`, three numbers a vertex; `morphs`, arrays of what each adds
    /// to it; and `bones`, pairs of arrays of joints and weights, four a vertex.
    bind(parts) {
        const {gl, places, pointCount} = this;
        let count = 0;
        this.beginnings = parts.map(({bones, morphs}) => {
            const last = bones.flatMap(([joints]) => [...joints]).reduce((a, b) => Math.max(a, b), 0);
            const matrices = count, weights = count + 16 * (last + 1);
            count = weights + 16 * Math.ceil(morphs.length / 16);
            return {matrices, weights};
        });
        const points = [], terms = [], held = TABLE_WIDTH * rowsOf(pointCount);
        for (let i = 0; i < pointCount; ++i) {
            const part = places[2 * i], v = places[2 * i + 1];
            points.push(...parts[part].position.slice(3 * v, 3 * v + 3), held + 1 + terms.length / 4);
            terms.push(...termsOf(parts[part], v, this.beginnings[part]));
        }
        for (let i = pointCount; i <= held; ++i) points.push(0, 0, 0, held + 1 + terms.length / 4);
        this.atRest.rest = this.table(gl.RGBA32F, new Float32Array([...points, ...terms]));
        this.numbers = new Float32Array(count);
        this.atRest.pose = this.table(gl.RGBA32F, this.numbers);
    }

    /// Moves the model, at least once before it is drawn. Of each part `matrices`, 16 numbers by columns for each bone, or for
    /// all of it without a skin, from rest to the world; and `weights` of its morphs. Edges are creases from so many degrees.
    pose(parts, creaseDeg = 40) {
        parts.forEach(({matrices, weights}, i) => {
            const begin = this.beginnings[i];
            this.numbers.set(matrices.slice(0, begin.weights - begin.matrices), begin.matrices);
            this.numbers.set(weights, begin.weights);
        });
        this.leastCosine = Math.cos(creaseDeg * Math.PI / 180);
        this.hasMoved = true;
    }

    /// Draws points, and the faces between them, into the tables.
    move() {
        const {atRest, tables} = this;
        this.fill(atRest.pose, this.numbers);
        for (const [name, program] of this.moves)
            this.run(program, this.posed[name], {...tables, ...atRest}, {least_cosine: this.leastCosine}, 3);
        this.hasMoved = false;
    }

    /// Draws the lines over the canvas, `view` and `projection` as 16 numbers by columns, of a projection whose depth is
    /// OpenGL's; ink 1 to 4 px wide. An engine's own notes of the context's state are wrong afterwards.
    draw(view, projection, widthPx = 1, color = [0, 0, 0]) {
        const {gl} = this;
        const {drawingBufferWidth: width, drawingBufferHeight: height} = gl;
        const margin = this.isInk ? Math.ceil(widthPx / 2) : 0;  // lines outside reach in
        const size = [width + 2 * margin, height + 2 * margin];
        if (String(size) !== String(this.size)) this.resize(...size);
        const shares = [width / size[0], height / size[1], 1, 1];
        const values = {modelViewMatrix: view, projectionMatrix: projection.map((value, i) => value * shares[i % 4]), size, widthPx};
        gl.bindVertexArray(this.empty);
        for (const state of [gl.BLEND, gl.CULL_FACE, gl.SCISSOR_TEST, gl.STENCIL_TEST, gl.DITHER]) gl.disable(state);
        gl.enable(gl.DEPTH_TEST);
        gl.depthFunc(gl.LESS);
        gl.depthMask(true);
        gl.colorMask(true, true, true, true);
        if (this.hasMoved) this.move();
        const [mesh, ...others] = this.targets;
        gl.bindFramebuffer(gl.FRAMEBUFFER, mesh.frame);
        for (const i of [0, 1]) gl.clearBufferuiv(gl.COLOR, i, [0, 0, 0, 0]);
        gl.clearBufferfv(gl.DEPTH, 0, [1]);
        this.run(this.mesh, mesh, this.tables, values, 3 * this.faceCount);
        gl.disable(gl.DEPTH_TEST);
        const drawn = {codes: mesh.textures[0], depths: mesh.textures[1], ...this.tables};
        this.steps.forEach(({program, by, draws}, i) => {
            const target = others[i];
            gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
            Object.values(draws).forEach((format, k) =>
                format === gl.RGBA8 ? gl.clearBufferfv(gl.COLOR, k, [0, 0, 0, 0]) : gl.clearBufferuiv(gl.COLOR, k, [0, 0, 0, 0]));
            const tiles = Math.ceil(target.width / TILE_PX) * Math.ceil(target.height / TILE_PX);
            const [columns, rows] = SIZES.ways(...size);
            if (by === 'spread') gl.enable(gl.BLEND), gl.blendEquation(gl.MAX);
            this.run(program, target, drawn, values, {screen: 3, tiles, spread: 3 * columns * rows}[by], by === 'tiles' ? gl.POINTS : gl.TRIANGLES);
            gl.disable(gl.BLEND);
            Object.keys(draws).forEach((name, k) => { drawn[name] = target.textures[k]; });
        });
        gl.enable(gl.BLEND);
        gl.blendEquation(gl.FUNC_ADD);
        gl.blendColor(...color, 1);
        gl.blendFuncSeparate(gl.CONSTANT_COLOR, gl.ONE_MINUS_SRC_COLOR, gl.ZERO, gl.ONE);
        this.run(this.lines, {frame: null, width, height}, drawn, values, 3);
    }
}
