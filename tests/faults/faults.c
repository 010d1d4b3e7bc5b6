// Library for LD_PRELOAD that counts the file operations of a program (creations, writes, flushes,
// links, renames, removals). Before operation number FAULT_AT the program is killed (FAULT=kill),
// or the disk is full from then on (FAULT=full).
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

static atomic_long count;
static long fault_at;
static int kills;

__attribute__((constructor)) static void begin(void) {
  const char* at = getenv("FAULT_AT");
  const char* what = getenv("FAULT");
  fault_at = at ? atol(at) : 0;
  kills = what && strcmp(what, "kill") == 0;
  unsetenv("LD_PRELOAD");  // child processes are not affected
}

// Writes the number of operations to the file FAULT_COUNT.
__attribute__((destructor)) static void end(void) {
  const char* to = getenv("FAULT_COUNT");
  FILE* const out = to ? fopen(to, "w") : NULL;
  if (!out) return;
  fprintf(out, "%ld", atomic_load(&count));
  fclose(out);
}

// Counts an operation; true if the disk is full.
static int full(void) {
  const long number = atomic_fetch_add(&count, 1) + 1;
  if (fault_at == 0 || number < fault_at) return 0;
  if (kills) kill(getpid(), SIGKILL);
  errno = ENOSPC;
  return 1;
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = flags & O_CREAT ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  if ((flags & O_CREAT) && full()) return -1;
  return ((int (*)(const char*, int, ...))dlsym(RTLD_NEXT, "open"))(path, flags, mode);
}

ssize_t write(int file, const void* bytes, size_t size) {
  if (file > 2 && full()) return -1;
  return REAL(write)(file, bytes, size);
}

int fsync(int file) { return full() ? -1 : REAL(fsync)(file); }
int link(const char* from, const char* to) { return full() ? -1 : REAL(link)(from, to); }
// Renaming and removing need no disk space.
int rename(const char* from, const char* to) {
  if (kills && full()) return -1;
  return REAL(rename)(from, to);
}
int remove(const char* path) {
  if (kills && full()) return -1;
  return REAL(remove)(path);
}
int unlink(const char* path) {
  if (kills && full()) return -1;
  return REAL(unlink)(path);
}
