// The surface lit from the eye, both sides alike: what stands under the lines.
//// vertex
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform mat3 normalMatrix;
in vec3 position;
in vec3 normal;
out vec3 p_view;
out vec3 n_view;

void main() {
    p_view = (modelViewMatrix * vec4(position, 1)).xyz;
    n_view = normalMatrix * normal;
    gl_Position = projectionMatrix * vec4(p_view, 1);
}
//// fragment
precision highp float;
in vec3 p_view;
in vec3 n_view;
layout(location = 0) out vec4 drawn;

void main() {
    float facing = abs(dot(normalize(n_view), normalize(vec3(-0.25, -0.35, -1))));
    drawn = vec4(mix(vec3(0.60, 0.66, 0.72), vec3(0.93, 0.945, 0.955), facing), 1);
}
