/* SPDX-License-Identifier: GPL-3.0-or-later */
/* export_xdmf.c - a description by which ParaView, VisIt and others read the results file itself
 * (xdmf.org, version 3): no number is copied. Keeps no state. Start reading at
 * fw_export_xdmf(). */
#include "experiments/storage/regular_file.h"
#include "experiments/storage/whole_file.h"
#include "exported.h"
#include "experiments/text/xml.h"

#include <stdlib.h>
#include <string.h>

#define TRAJECTORY "particles/trajectory"

/* One frame of a dataset of frames x N (x 3). */
static void write_slab(FILE *out, const fw_exported *e, const char *file, const char *name,
                       int64_t frame, int components)
{
    const long long frames = (long long)e->playback->frame_count, at = (long long)frame;
    const int count = e->playback->particle_count;
    const int rank = components > 1 ? 3 : 2;
    char width[16] = "";
    if (components > 1) snprintf(width, sizeof width, " %d", components);
    fprintf(out,
            "          <DataItem ItemType=\"HyperSlab\" Dimensions=\"%d%s\" NumberType=\"Float\" "
            "Precision=\"8\">\n",
            count, width);
    fprintf(out, "            <DataItem Dimensions=\"3 %d\" Format=\"XML\">%lld 0%s 1 1%s 1 %d%s",
            rank, at, components > 1 ? " 0" : "", components > 1 ? " 1" : "", count, width);
    fprintf(out,
            "</DataItem>\n            <DataItem Dimensions=\"%lld %d%s\" NumberType=\"Float\" "
            "Precision=\"8\" Format=\"HDF\">",
            frames, count, width);
    fw_xml_write_text(out, file);
    fprintf(out, ":/" TRAJECTORY "/%s/value</DataItem>\n          </DataItem>\n", name);
}

/* A whole dataset. */
static void write_whole(FILE *out, const char *file, const char *path, const char *extent,
                        const char *type, int bytes)
{
    fprintf(out,
            "          <DataItem Dimensions=\"%s\" NumberType=\"%s\" Precision=\"%d\" "
            "Format=\"HDF\">",
            extent, type, bytes);
    fw_xml_write_text(out, file);
    fprintf(out, ":/%s</DataItem>\n", path);
}

static void begin_attribute(FILE *out, const char *name, const char *type)
{
    fprintf(out, "        <Attribute Name=\"%s\" AttributeType=\"%s\" Center=\"Node\">\n", name,
            type);
}

static void end_attribute(FILE *out)
{
    fputs("        </Attribute>\n", out);
}

static void write_grid(FILE *out, const fw_exported *e, const char *file, int64_t frame)
{
    const fw_playback *playback = e->playback;
    char extent[48];
    fprintf(out,
            "      <Grid Name=\"step %lld\" GridType=\"Uniform\">\n"
            "        <Time Value=\"%.17g\"/>\n",
            (long long)e->steps[frame], e->times[frame]);
    if (playback->link_count > 0) {
        fprintf(out,
                "        <Topology TopologyType=\"Polyline\" NodesPerElement=\"2\" "
                "NumberOfElements=\"%d\">\n",
                playback->link_count);
        snprintf(extent, sizeof extent, "%d 2", playback->link_count);
        write_whole(out, file, "connectivity/links", extent, "Int", 4);
        fputs("        </Topology>\n", out);
    } else {
        fprintf(out, "        <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"%d\"/>\n",
                playback->particle_count);
    }
    fputs("        <Geometry GeometryType=\"XYZ\">\n", out);
    write_slab(out, e, file, "position", frame, 3);
    fputs("        </Geometry>\n", out);
    for (int v = 1; v < e->vector_count; ++v) {
        begin_attribute(out, e->vectors[v].name, "Vector");
        write_slab(out, e, file, e->vectors[v].name, frame, 3);
        end_attribute(out);
    }
    for (int f = 0; f < playback->field_count; ++f) {
        begin_attribute(out, playback->fields[f].name, "Scalar");
        write_slab(out, e, file, playback->fields[f].name, frame, 1);
        end_attribute(out);
    }
    snprintf(extent, sizeof extent, "%d", playback->particle_count);
    if (playback->mass) {
        begin_attribute(out, "mass", "Scalar");
        write_whole(out, file, TRAJECTORY "/mass", extent, "Float", 8);
        end_attribute(out);
    }
    begin_attribute(out, "id", "Scalar");
    write_whole(out, file, TRAJECTORY "/id", extent, "Int", 4);
    end_attribute(out);
    begin_attribute(out, "body", "Scalar");
    write_whole(out, file, TRAJECTORY "/body", extent, "Int", 4);
    end_attribute(out);
    fputs("      </Grid>\n", out);
}

static void write_all(FILE *out, const fw_exported *e, const char *file)
{
    fputs("<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n    <Grid Name=\"", out);
    fw_xml_write_text(out, e->playback->title);
    fputs("\" GridType=\"Collection\" CollectionType=\"Temporal\">\n", out);
    for (int64_t n = 0; n < fw_exported_count(e); ++n) write_grid(out, e, file, n * e->every);
    fputs("    </Grid>\n  </Domain>\n</Xdmf>\n", out);
}

/* How the results file is called from beside the description: readers look there. To be freed; NULL
 * without memory, or where the file has gone. */
static char *path_from(const char *name, const char *path)
{
    const char *slash = strrchr(name, '/');
    const size_t length = slash ? (size_t)(slash - name) + 1 : 0;
    const bool below = strncmp(path, name, length) == 0;
    return below && path[0] != '/' ? strdup(path + length) : realpath(path, NULL);
}

fw_status fw_export_xdmf(fw_exported *e, const char *name, fw_error *error)
{
    fw_whole_file *file;
    char *path = path_from(name, e->path);
    if (!path) return fw_fail_memory(error, "the name of the results file");
    fw_status status = fw_whole_file_begin(&file, name, error);
    if (status == FW_OK) {
        write_all(fw_whole_file_stream(file), e, path);
        status = fw_whole_file_commit(file, error);
    }
    free(path);
    return status;
}
