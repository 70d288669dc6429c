// _exit() writes no counts, and the processes of a study end by it (validation/processes.cpp): linked with --wrap=_exit in builds by preset
// coverage.

void __gcov_dump(void);
_Noreturn void __real__exit(int code);

_Noreturn void __wrap__exit(int code) {
    __gcov_dump();
    __real__exit(code);
}
