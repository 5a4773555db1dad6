/* SPDX-License-Identifier: GPL-3.0-or-later */
/* report_assets.h - report.css and report.js, as texts in the program (report_assets.cmake). */
#ifndef FW_REPORT_ASSETS_H
#define FW_REPORT_ASSETS_H

extern const char fw_report_style[], fw_report_script[];

#endif
