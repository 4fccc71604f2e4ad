// The shaders of methods, as their files are: sections begin with a line of four slashes.

/// {name: {text, vertex, fragment, screen, lines}}: the whole file, and its sections.
const SHADERS = Object.fromEntries(
    document.getElementById('shaders').textContent.split(/^\/\/\/\/ method /m).slice(1).map(file => {
        const end = file.indexOf('\n');
        const text = file.slice(end + 1);
        const [, ...sections] = text.split(/^\/\/\/\/ (\w+)\n/m);
        const shader = {text};
        for (let i = 0; i < sections.length; i += 2) shader[sections[i]] = sections[i + 1];
        return [file.slice(0, end), shader];
    }));

function compiled(gl, kind, source) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, `#version 300 es\n${source}`);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost())
        throw new Error(`a shader does not compile: ${gl.getShaderInfoLog(shader)}`);
    return shader;
}

/// A program with the places of its uniforms by name.
function programOf(gl, vertex, fragment) {
    const program = gl.createProgram();
    gl.attachShader(program, compiled(gl, gl.VERTEX_SHADER, vertex));
    gl.attachShader(program, compiled(gl, gl.FRAGMENT_SHADER, fragment));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
        throw new Error(`a program does not link: ${gl.getProgramInfoLog(program)}`);
    const uniforms = {};
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
        const {name, type} = gl.getActiveUniform(program, i);
        uniforms[name] = {place: gl.getUniformLocation(program, name), type};
    }
    return {program, uniforms};
}

/// Sets those of the values that the program reads.
function setUniforms(gl, {uniforms}, values) {
    for (const [name, {place, type}] of Object.entries(uniforms)) {
        const value = values[name];
        if (value === undefined) throw new Error(`no value for the uniform ${name}`);
        if (type === gl.FLOAT_MAT4) gl.uniformMatrix4fv(place, false, value);
        else if (type === gl.FLOAT_MAT3) gl.uniformMatrix3fv(place, false, value);
        else if (type === gl.FLOAT_VEC2) gl.uniform2fv(place, value);
        else if (type === gl.FLOAT_VEC3) gl.uniform3fv(place, value);
        else if (type === gl.FLOAT) gl.uniform1f(place, value);
        else if (type === gl.UNSIGNED_INT) gl.uniform1ui(place, value);
        else gl.uniform1i(place, value);
    }
}
