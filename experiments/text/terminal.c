/* SPDX-License-Identifier: GPL-3.0-or-later */
/* terminal.c - reads the system and the environment. Keeps no state. */
#include "experiments/text/terminal.h"

#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

bool fw_terminal_is(FILE *out)
{
    return isatty(fileno(out)) == 1;
}

int fw_terminal_width(FILE *out)
{
    enum { UNKNOWN = 80, LEAST = 20 };
    struct winsize size = {0};
    if (ioctl(fileno(out), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return UNKNOWN;
    return size.ws_col < LEAST ? LEAST : size.ws_col;
}

bool fw_terminal_colours(FILE *out)
{
    const char *without = getenv("NO_COLOR"), *kind = getenv("TERM");
    if (without && *without) return false;
    return fw_terminal_is(out) && kind && strcmp(kind, "dumb") != 0;
}
