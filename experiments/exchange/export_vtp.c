/* SPDX-License-Identifier: GPL-3.0-or-later */
/* export_vtp.c - VTK's PolyData, as ParaView and VisIt read it: NAME.pvd lists the frames by their
 * times, each a file of its own in the folder NAME.frames: particles as points, links as lines.
 * Numbers are the results file's, byte by byte. Keeps no state. Start reading at
 * fw_export_vtp(). */
#include "experiments/storage/folder.h"
#include "experiments/storage/regular_file.h"
#include "experiments/storage/whole_file.h"
#include "experiments/text/base64.h"
#include "experiments/text/xml.h"
#include "exported.h"

#include <assert.h>
#include <string.h>

#define INDENT "        "

/* VTK wants the number of bytes, as one of 64 bits, before the bytes. */
static fw_base64 begin_array(FILE *out, const char *type, const char *name, int components,
                             uint64_t bytes)
{
    fprintf(out,
            INDENT "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" "
                   "format=\"binary\">",
            type, name, components);
    fw_base64 letters = fw_base64_begin(out);
    fw_base64_write(&letters, &bytes, sizeof bytes);
    return letters;
}

static void end_array(fw_base64 *letters)
{
    fw_base64_end(letters);
    fputs("</DataArray>\n", letters->out);
}

static void write_scalars(FILE *out, const char *name, const double *values, int count)
{
    const size_t bytes = (size_t)count * sizeof *values;
    fw_base64 letters = begin_array(out, "Float64", name, 1, bytes);
    fw_base64_write(&letters, values, bytes);
    end_array(&letters);
}

static void write_vectors(FILE *out, const fw_exported_vector *vector, int count)
{
    fw_base64 letters = begin_array(out, "Float64", vector->name, 3, (uint64_t)count * 24);
    for (int i = 0; i < count; ++i)
        fw_base64_write(&letters, (double[]){vector->x[i], vector->y[i], 0}, 24);
    end_array(&letters);
}

/* number(n) for n from 0 on. */
static void write_integers(FILE *out, const char *name, int64_t count,
                           int64_t (*number)(const fw_exported *e, int64_t n), const fw_exported *e)
{
    fw_base64 letters = begin_array(out, "Int64", name, 1, (uint64_t)count * sizeof(int64_t));
    for (int64_t n = 0; n < count; ++n) {
        const int64_t value = number(e, n);
        fw_base64_write(&letters, &value, sizeof value);
    }
    end_array(&letters);
}

static int64_t itself(const fw_exported *e, int64_t n)
{
    (void)e;
    return n;
}

static int64_t next(const fw_exported *e, int64_t n)
{
    (void)e;
    return n + 1;
}

static int64_t twice_next(const fw_exported *e, int64_t n)
{
    (void)e;
    return 2 * (n + 1);
}

static int64_t body_at(const fw_exported *e, int64_t n)
{
    return e->body[n];
}

static int64_t link_end(const fw_exported *e, int64_t n)
{
    return e->playback->links[n / 2][n % 2];
}

static void write_frame(FILE *out, const fw_exported *e)
{
    const fw_playback *playback = e->playback;
    const int count = playback->particle_count, links = playback->link_count;
    fprintf(out,
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"%s\" "
            "header_type=\"UInt64\">\n"
            "  <PolyData>\n"
            "    <Piece NumberOfPoints=\"%d\" NumberOfVerts=\"%d\" NumberOfLines=\"%d\" "
            "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
            __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__ ? "LittleEndian" : "BigEndian", count, count,
            links);
    fputs("      <PointData>\n", out);
    for (int v = 1; v < e->vector_count; ++v) write_vectors(out, &e->vectors[v], count);
    for (int f = 0; f < playback->field_count; ++f)
        write_scalars(out, playback->fields[f].name, e->fields[f], count);
    if (playback->mass) write_scalars(out, "mass", e->mass, count);
    write_integers(out, "id", count, itself, e);
    write_integers(out, "body", count, body_at, e);
    fputs("      </PointData>\n      <Points>\n", out);
    write_vectors(out, &e->vectors[0], count);
    fputs("      </Points>\n      <Verts>\n", out);
    write_integers(out, "connectivity", count, itself, e);
    write_integers(out, "offsets", count, next, e);
    fputs("      </Verts>\n      <Lines>\n", out);
    write_integers(out, "connectivity", 2 * (int64_t)links, link_end, e);
    write_integers(out, "offsets", links, twice_next, e);
    fputs("      </Lines>\n    </Piece>\n  </PolyData>\n</VTKFile>\n", out);
}

static void print_frame_name(char name[32], int64_t n)
{
    snprintf(name, 32, "frame-%06lld.vtp", (long long)n);
}

/* Of an export before. */
static int64_t count_frames(const fw_folder *folder)
{
    char own[32];
    int64_t count = 0;
    for (print_frame_name(own, count); fw_folder_has(folder, own); print_frame_name(own, ++count)) {
    }
    return count;
}

/* Nobody lists frames that were made for a list that is not. */
static void take_back(fw_folder *folder, int64_t first, int64_t end)
{
    char own[32];
    fw_error ignored;
    for (int64_t n = first; n < end; ++n) {
        print_frame_name(own, n);
        (void)fw_folder_remove(folder, own, &ignored);
    }
    fw_folder_abandon(folder);
}

static fw_status write_frames(fw_exported *e, const char *folder, fw_error *error)
{
    for (int64_t n = 0; n < fw_exported_count(e); ++n) {
        char own[32], path[FW_PATH_SIZE];
        fw_whole_file *file;
        print_frame_name(own, n);
        FW_TRY(fw_path_join(path, folder, own, error));
        FW_TRY(fw_exported_read(e, n * e->every, error));
        FW_TRY(fw_whole_file_begin(&file, path, error));
        write_frame(fw_whole_file_stream(file), e);
        FW_TRY(fw_whole_file_commit(file, error));
    }
    return FW_OK;
}

/* `folder` as seen from the list. */
static fw_status write_list(const fw_exported *e, const char *name, const char *folder,
                            fw_error *error)
{
    fw_whole_file *file;
    FW_TRY(fw_whole_file_begin(&file, name, error));
    FILE *out = fw_whole_file_stream(file);
    fputs("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n"
          "  <Collection>\n",
          out);
    for (int64_t n = 0; n < fw_exported_count(e); ++n) {
        char own[32];
        print_frame_name(own, n);
        fprintf(out, "    <DataSet timestep=\"%.17g\" file=\"", e->times[n * e->every]);
        fw_xml_write_text(out, folder);
        fprintf(out, "/%s\"/>\n", own);
    }
    fputs("  </Collection>\n</VTKFile>\n", out);
    return fw_whole_file_commit(file, error);
}

fw_status fw_export_vtp(fw_exported *e, const char *name, fw_error *error)
{
    char folder[FW_PATH_SIZE];
    const size_t length = strlen(name);
    assert(length > 4 && strcmp(name + length - 4, ".pvd") == 0);
    if (snprintf(folder, sizeof folder, "%.*s.frames", (int)(length - 4), name) >= FW_PATH_SIZE)
        return fw_fail(error, FW_BAD_INPUT, "the name '%.60s...' is too long", name);
    fw_folder *frames;
    FW_TRY(fw_folder_create(&frames, folder, error));
    const int64_t before = count_frames(frames);
    const char *slash = strrchr(folder, '/');
    fw_status status = write_frames(e, folder, error);
    if (status == FW_OK) status = write_list(e, name, slash ? slash + 1 : folder, error);
    if (status == FW_OK)
        fw_folder_close(frames);
    else
        take_back(frames, before, fw_exported_count(e));
    return status;
}
