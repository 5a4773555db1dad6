/* SPDX-License-Identifier: GPL-3.0-or-later */
/* main.c - the program fretwork. */
#include <stdio.h>

int main(void)
{
    puts("fretwork");
    return 0;
}
