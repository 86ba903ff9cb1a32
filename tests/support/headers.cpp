// The program whose precompiled headers all test programs use; nothing runs it.
int main() { return 0; }
