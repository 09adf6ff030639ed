// Depths between which water is a film, m: from the first on there is a surface over the ground, from the second on it is
// drawn as the water's own. Between them everything changes gradually, so that no picture shows where a sample crosses one.
const vec2 film_m = vec2(0.004, 0.02);
