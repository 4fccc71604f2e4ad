// Draws with WebGL 2: the lines of a method into a texture, and parts of the picture from them.

const FORMATS = {
    R8UI: gl => [gl.R8UI, gl.RED_INTEGER, gl.UNSIGNED_BYTE],
    R32UI: gl => [gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT],
    RG32UI: gl => [gl.RG32UI, gl.RG_INTEGER, gl.UNSIGNED_INT],
    RGBA16UI: gl => [gl.RGBA16UI, gl.RGBA_INTEGER, gl.UNSIGNED_SHORT],
    RGBA32UI: gl => [gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT],
    RG8: gl => [gl.RG8, gl.RG, gl.UNSIGNED_BYTE],
    R8: gl => [gl.R8, gl.RED, gl.UNSIGNED_BYTE],
    RGBA8: gl => [gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE],
};

/// Texels in a row of a table, as the shaders have it.
const TABLE_WIDTH = 4096;
/// Sides of the squares in which marked pixels are drawn, as the shaders have it.
const TILE_PX = 4;

class Renderer {
    /// Throws an Error with a sentence where there is no WebGL 2.
    constructor(canvas, mesh) {
        const gl = canvas.getContext('webgl2', {antialias: false, depth: false, alpha: false});
        if (!gl) throw new Error('This browser gives the page no WebGL 2, by which it draws.');
        this.gl = gl;
        this.targets = new Map();
        this.programs = new Map();
        this.layouts = new Map();
        const {faces, points, poses, ...arrays} = mesh;
        this.buffers = Object.fromEntries(Object.entries(arrays).map(([name, values]) => {
            const kind = name === 'indices' ? gl.ELEMENT_ARRAY_BUFFER : gl.ARRAY_BUFFER;
            const buffer = gl.createBuffer();
            gl.bindBuffer(kind, buffer);
            gl.bufferData(kind, values, gl.STATIC_DRAW);
            return [name, buffer];
        }));
        this.empty = gl.createVertexArray();
        this.tables = {
            faces: this.table(faces, gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT),
            points: this.table(points, gl.RGBA32F, gl.RGBA, gl.FLOAT),
        };
        const clip = gl.getExtension('EXT_clip_control');
        this.isReversed = clip !== null;
        if (clip) clip.clipControlEXT(clip.LOWER_LEFT_EXT, clip.ZERO_TO_ONE_EXT);
        gl.disable(gl.DITHER);
        gl.disable(gl.BLEND);
    }

    /// Numbers as a texture of four a texel, 4096 texels a row.
    table(values, format, layout, type) {
        const {gl} = this;
        const height = Math.max(1, Math.ceil(values.length / (4 * TABLE_WIDTH)));
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, format, TABLE_WIDTH, height);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        this.writeTable(texture, values, layout, type);
        return texture;
    }

    writeTable(texture, values, layout, type) {
        const {gl} = this;
        const height = Math.max(1, Math.ceil(values.length / (4 * TABLE_WIDTH)));
        const whole = new values.constructor(4 * TABLE_WIDTH * height);
        whole.set(values);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, TABLE_WIDTH, height, layout, type, whole);
    }

    /// Arrays of the vertices by name, and the points of the tables, as they have moved.
    move(arrays, points) {
        const {gl} = this;
        for (const [name, values] of Object.entries(arrays)) {
            gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[name]);
            gl.bufferSubData(gl.ARRAY_BUFFER, 0, values);
        }
        this.writeTable(this.tables.points, points, gl.RGBA, gl.FLOAT);
    }

    /// Binds textures by the names of their uniforms; null takes one away. Returns their units.
    bind(textures) {
        const {gl} = this;
        return Object.fromEntries(Object.entries(textures).map(([name, texture], unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(gl.TEXTURE_2D, texture);
            return [name, unit];
        }));
    }

    /// What the browser says that draws.
    get name() {
        const {gl} = this;
        const info = gl.getExtension('WEBGL_debug_renderer_info');
        return String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    }

    get mostPx() {
        const {gl} = this;
        return Math.min(gl.getParameter(gl.MAX_TEXTURE_SIZE), gl.getParameter(gl.MAX_RENDERBUFFER_SIZE),
            ...gl.getParameter(gl.MAX_VIEWPORT_DIMS)) - 1;
    }

    program(name, vertex, fragment, hasClasses = false) {
        const key = `${name} ${vertex} ${fragment} ${hasClasses}`;
        const text = SHADERS[name][fragment].replace('has_classes = false', `has_classes = ${hasClasses}`);
        if (!this.programs.has(key)) this.programs.set(key, programOf(this.gl, SHADERS[name][vertex], text));
        return this.programs.get(key);
    }

    /// The mesh laid out for a program, by the names that it has for its arrays.
    layout(name, {program}, reads) {
        if (this.layouts.has(name)) return this.layouts.get(name);
        const {gl, buffers} = this;
        const layout = gl.createVertexArray();
        gl.bindVertexArray(layout);
        for (const [attribute, array] of Object.entries({position: 'position', ...reads})) {
            const place = gl.getAttribLocation(program, attribute);
            gl.bindBuffer(gl.ARRAY_BUFFER, buffers[array]);
            gl.enableVertexAttribArray(place);
            if (array === 'position') gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 12, 0);
            else if (array === 'id') gl.vertexAttribIPointer(place, 1, gl.UNSIGNED_INT, 4, 0);
            else if (array.endsWith('normal')) gl.vertexAttribPointer(place, 3, gl.SHORT, true, 8, 0);
            else gl.vertexAttribPointer(place, 1, gl.UNSIGNED_BYTE, false, 1, 0);
        }
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers.indices);
        this.layouts.set(name, layout);
        return layout;
    }

    /// Textures of these formats to draw into; the same for the same words.
    target(use, formats, width, height, hasDepth) {
        const key = [use, formats, width, height].join();
        if (this.targets.has(key)) return this.targets.get(key);
        const {gl} = this;
        const frame = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        const textures = formats.map((format, i) => {
            const texture = gl.createTexture();
            gl.bindTexture(gl.TEXTURE_2D, texture);
            gl.texStorage2D(gl.TEXTURE_2D, 1, FORMATS[format](gl)[0], width, height);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0);
            return texture;
        });
        gl.drawBuffers(formats.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
        const depth = hasDepth ? gl.createRenderbuffer() : null;
        if (depth) {
            gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
            gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, width, height);
            gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
        }
        if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE && !gl.isContextLost())
            throw new Error(`${formats.join(' + ')} of ${width} x ${height} is no target that this GPU draws into.`);
        const target = {frame, textures, depth, formats, width, height};
        this.targets.set(key, target);
        return target;
    }

    forgetTargets() {
        const {gl} = this;
        for (const {frame, textures, depth} of this.targets.values()) {
            gl.deleteFramebuffer(frame);
            textures.forEach(texture => gl.deleteTexture(texture));
            gl.deleteRenderbuffer(depth);
        }
        this.targets.clear();
    }

    /// Draws the mesh into a cleared target, one time per pass.
    drawMesh(name, reads, target, values, passes = [{}]) {
        const {gl} = this;
        const program = this.program(name, 'vertex', 'fragment');
        gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
        gl.viewport(0, 0, target.width, target.height);
        target.formats.forEach((format, i) => {
            if (format.endsWith('UI')) gl.clearBufferuiv(gl.COLOR, i, [0, 0, 0, 0]);
            else gl.clearBufferfv(gl.COLOR, i, [1, 1, 1, 1]);
        });
        gl.clearBufferfv(gl.DEPTH, 0, [this.isReversed ? 0 : 1]);
        gl.enable(gl.DEPTH_TEST);
        gl.depthFunc(this.isReversed ? gl.GREATER : gl.LESS);
        gl.bindVertexArray(reads ? this.layout(name, program, reads) : this.empty);
        gl.useProgram(program.program);
        const tables = reads ? {} : this.bind(this.tables);
        for (const pass of passes) {
            if (pass.hides) gl.enable(gl.CULL_FACE);
            if (pass.hides) gl.cullFace(gl[pass.hides]);
            setUniforms(gl, program, {...values, ...tables, ...pass});
            if (reads) gl.drawElements(gl.TRIANGLES, 3 * DATA.triangle_count, gl.UNSIGNED_INT, 0);
            else gl.drawArrays(gl.TRIANGLES, 0, 3 * DATA.face_count);
        }
        gl.disable(gl.CULL_FACE);
        gl.disable(gl.DEPTH_TEST);
    }

    /// Draws a section over a target by vertices of that name, or of several; what is not drawn over becomes 0.
    drawPass(name, section, by, target, textures, values) {
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
        gl.viewport(0, 0, target.width, target.height);
        target.formats.forEach((format, i) => {
            if (by === 'screen') return;
            if (format.endsWith('UI')) gl.clearBufferuiv(gl.COLOR, i, [0, 0, 0, 0]);
            else gl.clearBufferfv(gl.COLOR, i, [0, 0, 0, 0]);
        });
        for (const vertices of by.split(' '))
            this.drawSection(name, section, vertices, textures, {...values, target_size: [target.width, target.height]});
    }

    /// Draws a section of a shader into what is bound, with textures by the names of their uniforms: a triangle over all, the
    /// tiles that marks reach, or a triangle for each way, of which the greatest stay.
    drawSection(name, section, by, textures, values) {
        const {gl} = this;
        const program = this.program(name, by, section, values.hasClasses);
        gl.useProgram(program.program);
        const units = this.bind(textures);
        setUniforms(gl, program, {...values, ...units});
        gl.bindVertexArray(this.empty);
        if (by === 'spread') gl.enable(gl.BLEND), gl.blendEquation(gl.MAX);
        const [width, height] = by === 'spread' ? sizes.ways(...values.size) : values.target_size ?? [];
        if (by === 'screen') gl.drawArrays(gl.TRIANGLES, 0, 3);
        else if (by === 'spread') gl.drawArrays(gl.TRIANGLES, 0, 3 * width * height);
        else gl.drawArrays(gl.POINTS, 0, Math.ceil(width / TILE_PX) * Math.ceil(height / TILE_PX));
        gl.disable(gl.BLEND);
        // What is drawn into next must not be read.
        this.bind(Object.fromEntries(Object.keys(textures).map(name => [name, null])));
    }

    /// The lines of a method as a texture, 1 in its pixels; of ink as wide as asked the share of each. With `isClassed` the
    /// numbers of their classes are its green, of methods that tell them. `use` tells apart what is needed at one time. With samples at corners its rows run down (`isDown`), as those of an image: an edge
    /// through samples then goes to the face that the program gives it to.
    drawLines(name, camera, width, height, use = '', widthPx = 1, isClassed = false) {
        const {gl} = this;
        const {targets, reads, hasCorners, passes, isInk, steps = [], linesBy = 'screen'} = METHODS[name];
        const hasClasses = Boolean(isClassed && METHODS[name].hasClasses);
        const margin = isInk ? Math.ceil(widthPx / 2) : 0; // lines outside reach in
        const [w, h] = [width + 2 * margin, height + 2 * margin];
        const matrices = matricesOf(camera, width, height, this.isReversed);
        matrices.projectionMatrix[0] *= width / w;
        matrices.projectionMatrix[5] *= (hasCorners ? -height : height) / h;
        const values = {...matrices, cameraProjection: matrices.projectionMatrix, size: [w, h], widthPx, hasClasses};
        const more = hasCorners ? 1 : 0;
        const codes = this.target('codes', targets, w + more, h + more, true);
        this.drawMesh(name, reads, codes, values, passes);
        const drawn = {codes: codes.textures[0], depths: codes.textures[1] || null, ...reads ? {} : this.tables};
        for (const {section, by, draws, ofClasses, size} of steps) {
            const formats = hasClasses && ofClasses ? [ofClasses] : Object.values(draws);
            const target = this.target(section, formats, ...sizes[size](w, h), false);
            this.drawPass(name, section, by, target, drawn, values);
            Object.keys(draws).forEach((what, i) => { drawn[what] = target.textures[i]; });
        }
        const lines = this.target(`lines ${use}`, [hasClasses ? 'RG8' : 'R8'], width, height, false);
        this.drawPass(name, 'lines', linesBy, lines, drawn, values);
        return {...lines, isDown: Boolean(hasCorners)};
    }

    drawFill(camera, width, height) {
        const fill = this.target('fill', ['RGBA8'], width, height, true);
        this.drawMesh('fill', {normal: 'normal'}, fill, matricesOf(camera, width, height, this.isReversed));
        return fill;
    }

    /// Puts a part of the picture on the canvas: `part` and `seen` are {x, y, width, height} from below, and of
    /// the part only what is in `seen` is drawn.
    show(fill, lines, part, seen, looks) {
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(part.x, part.y, part.width, part.height);
        gl.enable(gl.SCISSOR_TEST);
        gl.scissor(seen.x, seen.y, seen.width, seen.height);
        this.drawSection('screen', 'lines', 'screen', {fill: fill.textures[0], mask: lines.textures[0]},
            {...looks, isDown: Number(lines.isDown), origin: [part.x, part.y], size: [part.width, part.height]});
        gl.disable(gl.SCISSOR_TEST);
    }

    /// White paper.
    clear() {
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.clearBufferfv(gl.COLOR, 0, [1, 1, 1, 1]);
    }

    /// Waits until all is drawn.
    finish(target) {
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    }

    /// A byte a pixel from the top, of its red.
    bytesOf({frame, width, height, isDown}, byteOf) {
        const {gl} = this;
        const read = new Uint8Array(4 * width * height);
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, read);
        const bytes = new Uint8Array(width * height);
        for (let y = 0; y < height; ++y)
            for (let x = 0; x < width; ++x) bytes[(isDown ? y : height - 1 - y) * width + x] = byteOf(read[4 * (y * width + x)]);
        return bytes;
    }
}
