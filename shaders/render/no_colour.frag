// For draws of depth alone.
void main() {}
