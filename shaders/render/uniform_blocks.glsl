// Lists of the blocks that uniform draws, by how many triangles they have at most: those of a simplified mesh, and last the
// raised mesh. C++ compiles these lines too (render/methods/simplified_envelope.h).
const int block_kinds = 4;
const int kind_triangles[block_kinds] = {32, 48, 64, 128};
// A block's words in the lists of simplified meshes.
const int block_words = 64;
