/*=========================================================================
 *
 *  Copyright The DentalSCR authors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
/* Faults at a moment that a test chooses: chance meets the moment between two renames once in a thousand runs, and on a
 * busy machine never. Testing/conftest.py compiles it and has the program load it before the C library.
 *
 *   DENTALSCR_KILL_AT=N          SIGKILL before the Nth change of a folder: a file made, renamed or removed
 *   DENTALSCR_TRUNCATE=PATH      the file is cut to a third after it was opened, before all of it is read
 *   DENTALSCR_TOUCH=PATH         the file gets another time after all of it was read, before it is closed
 *   DENTALSCR_OVERWRITE=PATH     its second half is written over, in place, when the first half of it was read
 *   DENTALSCR_REPLACE=PATH       PATH.other is renamed over it when all of it was read
 *   DENTALSCR_SWEEP=N            the first N temporary folders are removed as soon as they are made, as a sweep of
 * another process may do that finds them before they are locked
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static atomic_long changes;

static void
before_change(void)
{
  const char * const at = getenv("DENTALSCR_KILL_AT");
  if (at != NULL && atomic_fetch_add(&changes, 1) + 1 == atol(at))
  {
    kill(getpid(), SIGKILL);
    pause();
  }
}

#define NEXT(type, name) type const next = (type)dlsym(RTLD_NEXT, name)

typedef int (*path_function)(const char *);
typedef int (*paths_function)(const char *, const char *);
typedef int (*mode_function)(const char *, mode_t);
typedef int (*at_function)(int, const char *, int);
typedef int (*open_function)(const char *, int, ...);
typedef ssize_t (*read_function)(int, void *, size_t);

int
rename(const char * from, const char * to)
{
  NEXT(paths_function, "rename");
  before_change();
  return next(from, to);
}

int
remove(const char * path)
{
  NEXT(path_function, "remove");
  before_change();
  return next(path);
}

int
unlink(const char * path)
{
  NEXT(path_function, "unlink");
  before_change();
  return next(path);
}

int
rmdir(const char * path)
{
  NEXT(path_function, "rmdir");
  before_change();
  return next(path);
}

static void
sweep_folder(const char * path)
{
  NEXT(at_function, "unlinkat");
  next(AT_FDCWD, path, AT_REMOVEDIR);
}

int
mkdir(const char * path, mode_t mode)
{
  static atomic_long swept;
  NEXT(mode_function, "mkdir");
  before_change();
  const int          made = next(path, mode);
  const char * const sweep = getenv("DENTALSCR_SWEEP");
  const size_t       length = strlen(path);
  if (made == 0 && sweep != NULL && length > 5 && strcmp(path + length - 5, ".part") == 0 &&
      atomic_fetch_add(&swept, 1) < atol(sweep))
  {
    sweep_folder(path);
  }
  return made;
}

int
unlinkat(int folder, const char * path, int flags)
{
  NEXT(at_function, "unlinkat");
  before_change();
  return next(folder, path, flags);
}

int
open(const char * path, int flags, ...)
{
  NEXT(open_function, "open");
  if ((flags & O_CREAT) == 0)
  {
    return next(path, flags);
  }
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = va_arg(arguments, mode_t);
  va_end(arguments);
  before_change();
  return next(path, flags, mode);
}

/** Whether all of the file that a variable names is asked for: a look at its head, by which a format is told, is none.
 */
static int
is_whole(const char * variable, int file, size_t size)
{
  const char * const wanted = getenv(variable);
  struct stat        named;
  struct stat        opened;
  return wanted != NULL && stat(wanted, &named) == 0 && fstat(file, &opened) == 0 && named.st_dev == opened.st_dev &&
         named.st_ino == opened.st_ino && size >= (size_t)opened.st_size;
}

ssize_t
read(int file, void * data, size_t size)
{
  static atomic_int done;
  NEXT(read_function, "read");
  if (is_whole("DENTALSCR_TRUNCATE", file, size) && atomic_exchange(&done, 1) == 0)
  {
    const char * const path = getenv("DENTALSCR_TRUNCATE");
    struct stat        status;
    if (stat(path, &status) != 0 || truncate(path, status.st_size / 3) != 0)
    {
      abort();
    }
  }
  if (is_whole("DENTALSCR_OVERWRITE", file, size) && atomic_exchange(&done, 1) == 0)
  {
    const ssize_t       first = next(file, data, size / 2);
    const open_function open_next = (open_function)dlsym(RTLD_NEXT, "open");
    const int           again = open_next(getenv("DENTALSCR_OVERWRITE"), O_WRONLY);
    for (size_t at = size / 2; at < size; ++at)
    {
      if (pwrite(again, " ", 1, (off_t)at) != 1)
      {
        abort();
      }
    }
    close(again);
    return first;
  }
  const int     is_replaced = is_whole("DENTALSCR_REPLACE", file, size);
  const int     is_touched = is_whole("DENTALSCR_TOUCH", file, size);
  const ssize_t count = next(file, data, size);
  if (is_touched && atomic_exchange(&done, 1) == 0)
  {
    const struct timespec times[2] = { { 1, 0 }, { 1, 0 } };
    if (utimensat(AT_FDCWD, getenv("DENTALSCR_TOUCH"), times, 0) != 0)
    {
      abort();
    }
  }
  if (is_replaced && atomic_exchange(&done, 1) == 0)
  {
    char other[4096];
    snprintf(other, sizeof(other), "%s.other", getenv("DENTALSCR_REPLACE"));
    const paths_function rename_next = (paths_function)dlsym(RTLD_NEXT, "rename");
    if (rename_next(other, getenv("DENTALSCR_REPLACE")) != 0)
    {
      abort();
    }
  }
  return count;
}
