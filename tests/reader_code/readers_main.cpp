// What a reader may add to an exercise, to try it out: a main() that the grader must not begin with.
int main() { return 5; }
