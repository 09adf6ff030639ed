// One triangle over the whole picture.
out vec2 picture;  // -1 to 1, left to right and bottom to top

void main() {
    picture = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(picture, 0.0, 1.0);
}
