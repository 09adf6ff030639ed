// One triangle over the whole picture.
void main() {
    vec2 picture = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(picture, 0.0, 1.0);
}
