#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Generates cpp_emit/reserved/macros.txt and globals.txt from the headers below, with every installed compiler. Names
# that are already in the lists stay, so that lists of several systems can be combined. Run it in the project's folder.
set -e
lists=cpp_emit/reserved
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sed -n '/^#include/p' "$0" > "$work/all.hpp"
for compiler in g++ clang++; do
    command -v $compiler > /dev/null || continue
    for standard in c++17 gnu++17 c++20 gnu++20; do
        $compiler -std=$standard -D_GNU_SOURCE -dM -E -x c++ "$work/all.hpp" | awk '{print $2}' | sed 's/(.*//' >> "$work/macros"
    done
done
# The names that C headers declare at the top level, and enumerators.
sed -n -e 's/<c\(assert\|ctype\|errno\|fenv\|float\|inttypes\|limits\|locale\|math\|setjmp\|signal\|stdarg\|stddef\|stdint\|stdio\|stdlib\|string\|time\|uchar\|wchar\|wctype\)>/<\1.h>/' \
    -e '/\.h>/p' "$work/all.hpp" | sort -u > "$work/all.h"
for compiler in gcc clang; do
    command -v $compiler > /dev/null || continue
    $compiler -std=gnu17 -D_GNU_SOURCE -E -P -x c "$work/all.h"
done | awk '
{
    gsub(/"(\\.|[^"\\])*"/, "\"\"")
    text = $0
    while (match(text, /[A-Za-z_][A-Za-z_0-9]*|[{}()*]|[0-9][A-Za-z_0-9.]*/)) {
        word = substr(text, RSTART, RLENGTH); text = substr(text, RSTART + RLENGTH)
        if (word == "{") { level[++depth] = (last == "enum" || before == "enum") ? "e" : "{" }
        else if (word == "(") { level[++depth] = "(" }
        else if (word == "}" || word == ")") { if (depth > 0) --depth }
        else if (word ~ /^[A-Za-z]/) {
            free = 1
            for (i = 1; i <= depth; ++i) if (level[i] != "e") free = 0
            if (free || (depth == 1 && level[1] == "(" && last == "*")) print word
        }
        before = last; last = word
    }
}' | grep -vxE 'auto|break|case|char|const|continue|default|do|double|else|enum|extern|float|for|goto|if|inline|int|long|register|restrict|return|short|signed|sizeof|static|struct|switch|typedef|union|unsigned|void|volatile|while' > "$work/globals"
for list in macros globals; do
    head -n 1 $lists/$list.txt > "$work/new"
    { sed -n '2,$p' $lists/$list.txt; grep -E '^[A-Za-z][A-Za-z0-9_]*$' "$work/$list"; } | LC_ALL=C sort -u >> "$work/new"
    mv "$work/new" $lists/$list.txt
done
exit 0

#include <algorithm>
#include <any>
#include <array>
#include <atomic>
#include <bitset>
#include <charconv>
#include <chrono>
#include <complex>
#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <forward_list>
#include <fstream>
#include <functional>
#include <future>
#include <initializer_list>
#include <iomanip>
#include <ios>
#include <iosfwd>
#include <iostream>
#include <istream>
#include <iterator>
#include <limits>
#include <list>
#include <locale>
#include <map>
#include <memory>
#include <memory_resource>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <ostream>
#include <queue>
#include <random>
#include <ratio>
#include <regex>
#include <scoped_allocator>
#include <set>
#include <shared_mutex>
#include <sstream>
#include <stack>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <tuple>
#include <type_traits>
#include <typeindex>
#include <typeinfo>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <valarray>
#include <variant>
#include <vector>
#include <cassert>
#include <cctype>
#include <cerrno>
#include <cfenv>
#include <cfloat>
#include <cinttypes>
#include <climits>
#include <clocale>
#include <cmath>
#include <csetjmp>
#include <csignal>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <cuchar>
#include <cwchar>
#include <cwctype>
#include <complex.h>
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <grp.h>
#include <netdb.h>
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <pthread.h>
#include <pwd.h>
#include <regex.h>
#include <sched.h>
#include <semaphore.h>
#include <setjmp.h>
#include <signal.h>
#include <spawn.h>
#include <strings.h>
#include <syslog.h>
#include <termios.h>
#include <unistd.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/time.h>
#include <sys/times.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <utime.h>
#include <wchar.h>
#include <wctype.h>
