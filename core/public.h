/* SPDX-License-Identifier: GPL-3.0-or-later */
/* public.h - what libfretwork offers: functions and tables that a header declares between
 * FW_PUBLIC_BEGIN and FW_PUBLIC_END are seen by programs that link it, from C and from C++. All
 * else stays inside. Such a header is listed as PUBLIC by its wing, and installed. */
#ifndef FW_PUBLIC_H
#define FW_PUBLIC_H

#ifdef __cplusplus
#define FW_PUBLIC_BEGIN                                                                            \
    _Pragma("GCC visibility push(default)") extern "C"                                             \
    {
#define FW_PUBLIC_END                                                                              \
    }                                                                                              \
    _Pragma("GCC visibility pop")
#else
#define FW_PUBLIC_BEGIN _Pragma("GCC visibility push(default)")
#define FW_PUBLIC_END   _Pragma("GCC visibility pop")
#endif

#endif
