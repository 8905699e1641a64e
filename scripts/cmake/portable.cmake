# SPDX-License-Identifier: Apache-2.0
# With ROBOCHART_PORTABLE the program needs only the C library. libstdc++, libgcc, libsodium and Expat are linked
# statically. fmt, for which Debian has only a shared library, is compiled from its headers. ROBOCHART_FMT is the
# library to link. Generated code that the program loads contains the libstdc++ of its compiler: the interface between
# the two is C, and no exception and no C++ type crosses it.
set(ROBOCHART_FMT fmt::fmt)
if(ROBOCHART_PORTABLE)
  if(NOT fmt_VERSION MATCHES "^9\\.")
    message(FATAL_ERROR "ROBOCHART_PORTABLE knows what the library of fmt 9 defines; this is fmt ${fmt_VERSION}")
  endif()
  # The definitions of functions that the headers declare, and the instantiations that they declare `extern template` or
  # leave to the library.
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/fmt.cpp CONTENT [[
#include <fmt/format-inl.h>

FMT_BEGIN_NAMESPACE
namespace detail {
template thousands_sep_result<char> thousands_sep_impl<char>(locale_ref);
template char decimal_point_impl<char>(locale_ref);
template void buffer<char>::append(const char*, const char*);
template dragonbox::decimal_fp<float> dragonbox::to_decimal(float) noexcept;
template dragonbox::decimal_fp<double> dragonbox::to_decimal(double) noexcept;
}
FMT_END_NAMESPACE
]])
  add_library(robochart_fmt STATIC ${CMAKE_BINARY_DIR}/fmt.cpp)
  target_compile_options(robochart_fmt PRIVATE -w)
  # The same compile options as with the shared library, so that objects are identical.
  target_compile_definitions(robochart_fmt PUBLIC FMT_SHARED)
  set(ROBOCHART_FMT robochart_fmt)
  find_library(SODIUM_LIBRARY libsodium.a REQUIRED)
  # Debian's libexpat.a seeds its tables with a function that is only in the C library since 2.36. With this definition
  # the program also starts on older systems.
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/arc4random_buf.cpp CONTENT [[
#include <sys/random.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>

extern "C" void arc4random_buf(void* buffer, std::size_t size) noexcept {
    auto* at = static_cast<unsigned char*>(buffer);
    while (size > 0) {
        const ssize_t got = getrandom(at, size, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) std::abort();
        at += got;
        size -= static_cast<std::size_t>(got);
    }
}
]])
  add_library(robochart_random_seed STATIC ${CMAKE_BINARY_DIR}/arc4random_buf.cpp)
  find_library(EXPAT_ARCHIVE libexpat.a REQUIRED)
  add_library(robochart_expat STATIC IMPORTED GLOBAL)
  set_target_properties(robochart_expat PROPERTIES IMPORTED_LOCATION ${EXPAT_ARCHIVE}
                                                   INTERFACE_LINK_LIBRARIES robochart_random_seed)
  set(EXPAT_LIBRARY robochart_expat)
  # Removes unused code, including the parts of libstdc++ that call the newest functions of the C library.
  add_link_options(-static-libstdc++ -static-libgcc -Wl,--gc-sections)
endif()
