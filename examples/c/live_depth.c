/* Live depth in a pipe: raw grey frames from stdin, those of one scene one after the other in the order of the lenses (near
 * focus, far focus, near focus, ...), and a float32 map to stdout as soon as its last frame is there.
 *
 *     camera | live_depth lens.lml 640x480 --bits 8 | viewer
 *
 * lens.lml is what LiveDepth.save() of the Python package wrote. Frames are rows of bytes, or of words of 16 bits in the order of
 * this machine, without headers. Once it has started it allocates nothing. */
#define _DEFAULT_SOURCE /* sigaction in glibc by -std=c11 */
#include <errno.h>
#include <inttypes.h>
#include <lommel.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#endif

static const char usage[] =
    "usage: live_depth TABLES WIDTHxHEIGHT [--bits 8|16] [--write depth|errors|sharp] [--alternating] [--threads N]\n"
    "  --bits 16       bits of a pixel in the frames that come from stdin\n"
    "  --write depth   maps of (height / 4) x (width / 4) float32, metres, NaN where not known\n"
    "  --write errors  the same, and a map of their standard errors after each\n"
    "  --write sharp   sharp images of height x width float32, electrons\n"
    "  --alternating   for a lens that changes focus from frame to frame: a map after every frame, with those before it\n"
    "  --threads 1     threads\n"
    "Exit code: 0, 1 where reading or writing failed, 2 for wrong arguments or tables, 3 where frames were left without a "
    "map, 128 and the signal's number where interrupted (130 by Ctrl-C).\n";

enum { failed = 1, wrong = 2, incomplete = 3 };
enum { most_frames = 16, most_bytes = 1 << 25 };

static struct {
    const char* tables;
    int32_t width, height, bits, threads;
    int errors, sharp, alternating;
} asked = {NULL, 0, 0, 16, 1, 0, 0, 0};

enum { bins = 2000 };
static const double bin_width = 0.01;

static struct {
    long taken, maps, refused, computed; /* frames, maps written, those of NaN, and those that depth was found for */
    unsigned long long known, misfits[bins]; /* blocks, and how many have each misfit, for its median */
    double began, ended, computing;          /* seconds */
} done;

static volatile sig_atomic_t interrupted; /* by a signal of this number */
#ifndef _WIN32
static void interrupt(int signal) { interrupted = signal; }

/* Reading and writing then end where they are. The second signal ends the program. */
static void end_at(int signal) {
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = interrupt;
    action.sa_flags = (int)SA_RESETHAND;
    sigaction(signal, &action, NULL);
}
#endif

static int understood(int arguments, char** argument) {
    char rest;
    if (arguments < 3 || sscanf(argument[2], "%5" SCNd32 "x%5" SCNd32 "%c", &asked.width, &asked.height, &rest) != 2) {
        return 0;
    }
    asked.tables = argument[1];
    for (int i = 3; i < arguments; ++i) {
        if (strcmp(argument[i], "--alternating") == 0) {
            asked.alternating = 1;
            continue;
        }
        if (i + 1 == arguments) {
            return 0;
        }
        const char *const name = argument[i++], *const value = argument[i];
        if (strcmp(name, "--bits") == 0 && (strcmp(value, "8") == 0 || strcmp(value, "16") == 0)) {
            asked.bits = strcmp(value, "8") == 0 ? 8 : 16;
        } else if (strcmp(name, "--threads") == 0 && sscanf(value, "%5" SCNd32 "%c", &asked.threads, &rest) == 1) {
        } else if (strcmp(name, "--write") == 0 && strcmp(value, "errors") == 0) {
            asked.errors = 1;
        } else if (strcmp(name, "--write") == 0 && strcmp(value, "sharp") == 0) {
            asked.sharp = 1;
        } else if (strcmp(name, "--write") != 0 || strcmp(value, "depth") != 0) {
            return 0;
        }
    }
    return !(asked.errors && asked.sharp);
}

/* NULL, with a sentence on stderr, where there are no such tables. */
static lommel_live* open_tables(void) {
    FILE* const file = fopen(asked.tables, "rb");
    void* const bytes = malloc(most_bytes);
    lommel_live* live = NULL;
    if (file == NULL || bytes == NULL) {
        perror(asked.tables);
    } else {
        const size_t size = fread(bytes, 1, most_bytes, file);
        if (ferror(file)) {
            perror(asked.tables);
        } else if ((live = lommel_live_new(bytes, size, asked.height, asked.width, asked.threads)) == NULL) {
            fprintf(stderr, "%s: %s\n", asked.tables, lommel_message());
        }
    }
    free(bytes);
    if (file != NULL) {
        fclose(file);
    }
    return live;
}

static double seconds(void) {
    struct timespec time;
    timespec_get(&time, TIME_UTC);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void count_known(const float* errors, const float* misfit, size_t blocks) {
    ++done.computed;
    for (size_t i = 0; i < blocks; ++i) {
        if (isfinite(errors[i])) {
            const double bin = misfit[i] / bin_width;
            ++done.misfits[bin > 0.0 ? (bin < bins - 1 ? (int)bin : bins - 1) : 0];
            ++done.known;
        }
    }
}

static void summarize(int32_t down, int32_t across) {
    fprintf(stderr, "%ld maps of %" PRId32 "x%" PRId32 " from %ld frames of %" PRId32 "x%" PRId32, done.maps,
            asked.sharp ? asked.width : across, asked.sharp ? asked.height : down, done.taken, asked.width, asked.height);
    if (done.ended > done.began) {
        fprintf(stderr, ": %.4g frames/s, %.3g ms a map in lommel", (double)(done.taken - 1) / (done.ended - done.began),
                1e3 * done.computing / (double)done.maps);
    }
    if (done.computed > 0) {
        const double share = (double)done.known / ((double)done.computed * (double)down * (double)across);
        unsigned long long below = done.misfits[0];
        int median = 0;
        while (median < bins - 1 && below < (done.known + 1) / 2) {
            below += done.misfits[++median];
        }
        const double misfit = (median + 0.5) * bin_width;
        fprintf(stderr, "; %.1f %% known", 100.0 * share);
        if (done.known > 0) {
            fprintf(stderr, ", median misfit %.2f", misfit);
        }
        if (share < 0.1 || misfit < 0.7 || misfit > 2.0) {
            fputs("\ncheck the size of the frames, bits, registration, and the noise of the tables: misfit should be 1",
                  stderr);
        }
    }
    fputs("\n", stderr);
}

int main(int arguments, char** argument) {
    if (!understood(arguments, argument)) {
        fputs(usage, stderr);
        return wrong;
    }
    lommel_live* const live = open_tables();
    int32_t count, down, across;
    if (live == NULL || lommel_live_size(live, &count, &down, &across) != LOMMEL_OK) {
        return wrong;
    }
    const size_t blocks = (size_t)down * (size_t)across, pixels = (size_t)asked.height * (size_t)asked.width;
    const size_t frame_bytes = pixels * (size_t)asked.bits / 8,
                 values = asked.sharp ? pixels : (size_t)(1 + asked.errors) * blocks;
    /* Depth, standard error and misfit are one after the other, and each frame has a place of its own. */
    float *const maps = malloc(3 * blocks * sizeof *maps), *const image = malloc((asked.sharp ? pixels : 1) * sizeof *image);
    const void* frames[most_frames] = {NULL};
    char* const memory = malloc((size_t)count * frame_bytes);
    if (maps == NULL || image == NULL || memory == NULL) {
        fputs("memory could not be allocated\n", stderr);
        return failed;
    }
    for (int32_t i = 0; i < count; ++i) {
        frames[i] = memory + (size_t)i * frame_bytes;
    }
    float* const written = asked.sharp ? image : maps;
#ifdef _WIN32
    _setmode(_fileno(stdin), _O_BINARY), _setmode(_fileno(stdout), _O_BINARY);
#else
    signal(SIGPIPE, SIG_IGN); /* a reader that goes away is then seen when writing */
    end_at(SIGINT), end_at(SIGTERM);
#endif
    setvbuf(stdin, NULL, _IONBF, 0), setvbuf(stdout, NULL, _IONBF, 0);

    size_t got = 0;
    int code = 0, unread = 0;
    while (!interrupted &&
           (got = fread(memory + (size_t)(done.taken % count) * frame_bytes, 1, frame_bytes, stdin)) == frame_bytes) {
        const double now = seconds();
        done.began = done.taken++ == 0 ? now : done.began;
        if (asked.alternating ? done.taken < count : done.taken % count != 0) {
            continue;
        }
        if (lommel_live_frames(live, frames, asked.bits, asked.width, maps, maps + blocks, maps + 2 * blocks) == LOMMEL_OK) {
            count_known(maps + blocks, maps + 2 * blocks, blocks);
            if (asked.sharp && lommel_live_sharp(live, image) != LOMMEL_OK) {
                fprintf(stderr, "%s: %s\n", asked.tables, lommel_message());
                code = wrong;
                break;
            }
        } else { /* the maps stay in step with the frames */
            fprintf(stderr, "map %ld is NaN: %s\n", done.maps, lommel_message());
            ++done.refused;
            for (size_t i = 0; i < values; ++i) {
                written[i] = NAN;
            }
        }
        done.computing += seconds() - now;
        if (fwrite(written, sizeof *written, values, stdout) != values || fflush(stdout) != 0) {
            unread = errno == EPIPE;
            code = unread ? 0 : failed;
            if (!interrupted) {
                perror("writing maps");
            }
            break;
        }
        ++done.maps;
        done.ended = seconds();
    }

    if (interrupted) {
        fputs("interrupted: the last frame or map may be incomplete\n", stderr);
        code = 128 + interrupted;
    } else if (got < frame_bytes) {
        if (ferror(stdin)) {
            perror("reading frames");
            code = failed;
        } else if (got > 0) {
            fprintf(stderr, "frame %ld ends after %zu of %zu bytes: it is left out\n", done.taken, got, frame_bytes);
            code = incomplete;
        }
        if (asked.alternating ? done.taken < count : done.taken % count != 0) {
            fprintf(stderr, "%ld frames: the last have no map, which takes %" PRId32 "\n", done.taken, count);
            code = code == 0 ? incomplete : code;
        }
    }
    if (done.refused > 0 || (done.maps == 0 && !unread)) {
        code = code == 0 ? incomplete : code;
    }
    summarize(down, across);
    lommel_live_free(live);
    free(memory), free(image), free(maps);
    return code;
}
