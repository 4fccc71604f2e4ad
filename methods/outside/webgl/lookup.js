// Draws the lines of surface_lookup, chords or strokes over what a WebGL 2 context shows, whichever engine drew that.

const TABLE_WIDTH = 4096, TILE_PX = 4;  // texels in a row, and sides of marked squares, as the shaders have them

/// The shader of a method, with what it takes from others' files ("//// screen of surface8") in its place.
function wholeShader(method, files) {
    return files[method].replace(/^(\/\/(?:\/\/|--)) (\w+) of (\w+)\n/gm, (_, mark, part, other) => {
        const text = other === method ? files[other] : wholeShader(other, files);
        const begin = text.indexOf(`${mark} ${part}\n`), end = text.indexOf(`\n${mark} `, begin);
        return text.slice(begin, end < 0 ? text.length : end + 1);
    });
}

export class LookupLines {
    /// `files`: the texts of surface8.glsl, surface_lookup.glsl, chords.glsl and strokes.glsl by method. `faces`: eight words a face.
    /// Before each frame that moves them fill `points`: four floats each, the last of them 1.
    constructor(gl, method, files, faces, pointCount) {
        const [, ...parts] = wholeShader(method, files).split(/^\/\/\/\/ (\w+)\n/m);
        const sections = Object.fromEntries(parts.flatMap((text, i) => i % 2 ? [] : [[text, parts[i + 1]]]));
        const program = (vertex, fragment) => this.program(sections[vertex], sections[fragment]);
        this.gl = gl;
        this.faceCount = faces.length / 8;
        this.points = new Float32Array(4 * TABLE_WIDTH * Math.ceil(pointCount / TABLE_WIDTH));
        this.tables = {faces: this.texture(gl.RGBA32UI, TABLE_WIDTH, Math.ceil(2 * this.faceCount / TABLE_WIDTH)),
            points: this.texture(gl.RGBA32F, TABLE_WIDTH, Math.ceil(pointCount / TABLE_WIDTH))};
        this.faces = new Uint32Array(4 * TABLE_WIDTH * Math.ceil(2 * this.faceCount / TABLE_WIDTH));
        this.faces.set(faces);
        this.fill(this.tables.faces, gl.RGBA_INTEGER, gl.UNSIGNED_INT, this.faces);
        this.empty = gl.createVertexArray();
        this.mesh = program('vertex', 'fragment');
        this.isInk = method !== 'surface_lookup';
        const linesOfSides = {surface_lookup: gl.R8UI, chords: gl.RGBA16UI, strokes: gl.RGBA32UI}[method];
        this.steps = [['marks', program('screen', 'marks'), gl.R8UI], ['sides', program('tiles', 'sides'), linesOfSides]];
        if (this.isInk) this.steps.push(['pieces', program('tiles', 'cells'), gl.RGBA32UI]);
        this.lines = program('screen', 'lines');
        this.targets = [];
    }

    texture(format, width, height) {
        const {gl} = this;
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
        for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
        return texture;
    }

    fill(texture, layout, type, values) {
        const {gl} = this;
        gl.bindTexture(gl.TEXTURE_2D, texture);
        for (const [name, value] of [['FLIP_Y_WEBGL', false], ['PREMULTIPLY_ALPHA_WEBGL', false], ['ALIGNMENT', 4]])
            gl.pixelStorei(gl[`UNPACK_${name}`], value);  // engines leave their own
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, TABLE_WIDTH, values.length / (4 * TABLE_WIDTH), layout, type, values);
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
        const more = [width + 1, height + 1];
        this.targets = [this.target([gl.R32UI, gl.R32UI], ...more, true)];
        for (const [name, , format] of this.steps)
            this.targets.push(name === 'pieces' ? this.target([format], width, height, false) : this.target([format], ...more, false));
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
        for (const name of ['modelViewMatrix', 'projectionMatrix'])
            gl.uniformMatrix4fv(gl.getUniformLocation(program, name), false, values[name]);
        gl.uniform2fv(gl.getUniformLocation(program, 'size'), values.size);
        gl.uniform2f(gl.getUniformLocation(program, 'target_size'), target.width, target.height);
        gl.uniform1f(gl.getUniformLocation(program, 'widthPx'), values.widthPx);
        gl.drawArrays(kind, 0, count);
    }

    /// Creases as `points` are now bent, at so many degrees or more: without it they stay those of the tables' pose.
    fold(creaseDeg = 40) {
        const {gl, faces, points, faceCount} = this;
        const normals = new Float64Array(3 * faceCount);
        for (let f = 0; f < faceCount; ++f) {
            const [a, b, c] = [4 * faces[8 * f], 4 * faces[8 * f + 1], 4 * faces[8 * f + 2]];
            const [x, y, z] = [points[b] - points[a], points[b + 1] - points[a + 1], points[b + 2] - points[a + 2]];
            const [u, v, w] = [points[c] - points[a], points[c + 1] - points[a + 1], points[c + 2] - points[a + 2]];
            const length = Math.hypot(y * w - z * v, z * u - x * w, x * v - y * u);
            normals.set([(y * w - z * v) / length, (z * u - x * w) / length, (x * v - y * u) / length], 3 * f);
        }
        const least = Math.cos(creaseDeg * Math.PI / 180);
        for (let f = 0; f < faceCount; ++f) {
            let rest = faces[8 * f + 7] & ~0x800000;
            for (let i = 0; i < 3; ++i) {
                const twin = faces[8 * f + 4 + i];
                if (twin === 0xfffffffb) rest |= 0x800000;  // an edge of many faces
                if (twin >= 0xfffffffb) continue;
                const g = (twin & 0x3ffffffc) >> 2, other = faces[8 * g + 7];
                const cosine = normals[3 * f] * normals[3 * g] + normals[3 * f + 1] * normals[3 * g + 1] + normals[3 * f + 2] * normals[3 * g + 2];
                const isCrease = (twin >>> 31 ? -cosine : cosine) <= least;
                const kind = isCrease ? 3 : (rest ^ other) & 0x7ffe00 ? 5 : 0;
                rest = rest & ~(7 << 3 * i) | kind << 3 * i;
                // What codes do not tell is looked up.
                if ((kind !== 0) !== (Math.abs((rest >>> 24) - (other >>> 24)) >= 2)) rest |= 0x800000;
            }
            faces[8 * f + 7] = rest;
        }
        this.fill(this.tables.faces, gl.RGBA_INTEGER, gl.UNSIGNED_INT, faces);
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
        this.fill(this.tables.points, gl.RGBA, gl.FLOAT, this.points);
        gl.bindVertexArray(this.empty);
        for (const state of [gl.BLEND, gl.CULL_FACE, gl.SCISSOR_TEST, gl.STENCIL_TEST, gl.DITHER]) gl.disable(state);
        gl.enable(gl.DEPTH_TEST);
        gl.depthFunc(gl.LESS);
        gl.depthMask(true);
        gl.colorMask(true, true, true, true);
        const [mesh, ...others] = this.targets;
        gl.bindFramebuffer(gl.FRAMEBUFFER, mesh.frame);
        for (const i of [0, 1]) gl.clearBufferuiv(gl.COLOR, i, [0, 0, 0, 0]);
        gl.clearBufferfv(gl.DEPTH, 0, [1]);
        this.run(this.mesh, mesh, this.tables, values, 3 * this.faceCount);
        gl.disable(gl.DEPTH_TEST);
        const drawn = {codes: mesh.textures[0], depths: mesh.textures[1], ...this.tables};
        this.steps.forEach(([name, step], i) => {
            const target = others[i];
            if (i === 0) {
                this.run(step, target, drawn, values, 3);
            } else {
                gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
                gl.clearBufferuiv(gl.COLOR, 0, [0, 0, 0, 0]);
                const tiles = Math.ceil(target.width / TILE_PX) * Math.ceil(target.height / TILE_PX);
                this.run(step, target, drawn, values, tiles, gl.POINTS);
            }
            drawn[name] = target.textures[0];
        });
        gl.enable(gl.BLEND);
        gl.blendEquation(gl.FUNC_ADD);
        gl.blendColor(...color, 1);
        gl.blendFuncSeparate(gl.CONSTANT_COLOR, gl.ONE_MINUS_SRC_COLOR, gl.ZERO, gl.ONE);
        this.run(this.lines, {frame: null, width, height}, drawn, values, 3);
    }
}
