/* What the assembler made of span.S: no executable stack, and fit for control-flow enforcement. */
#define _POSIX_C_SOURCE 200809L
#include "tests/asm/asm.h"

#ifdef TEXMAP_STAGE5

#include <elf.h>
#include <glob.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "tests/files/error.h"

#define OBJECT_MAX (1 << 20) /* bytes */
#define FEATURE_1_AND 0xc0000002u /* GNU_PROPERTY_X86_FEATURE_1_AND, and its bits */
#define IBT_AND_SHSTK 3u

struct object {
    unsigned char bytes[OBJECT_MAX];
    size_t size;
};

static bool object_read(struct object *object, const char *path)
{
    FILE *file = fopen(path, "rb");

    if (!file) {
        return false;
    }
    object->size = fread(object->bytes, 1, sizeof object->bytes, file);
    fclose(file);
    return object->size > sizeof(Elf64_Ehdr) && memcmp(object->bytes, ELFMAG, SELFMAG) == 0;
}

/* The header of the section of that name. False where there is none. */
static bool section_find(const struct object *object, const char *name, Elf64_Shdr *section)
{
    Elf64_Ehdr header;
    Elf64_Shdr names;

    memcpy(&header, object->bytes, sizeof header);
    if (header.e_shoff + (uint64_t)header.e_shnum * sizeof names > object->size ||
        header.e_shstrndx >= header.e_shnum) {
        return false;
    }
    memcpy(&names, object->bytes + header.e_shoff + header.e_shstrndx * sizeof names, sizeof names);
    for (int i = 0; i < header.e_shnum; i++) {
        memcpy(section, object->bytes + header.e_shoff + (size_t)i * sizeof *section,
               sizeof *section);
        const uint64_t start = names.sh_offset + section->sh_name;
        if (start + strlen(name) < object->size &&
            memcmp(object->bytes + start, name, strlen(name) + 1) == 0) {
            return true;
        }
    }
    return false;
}

/* Without the note the linker takes it that the stack must be executable. */
static bool stack_not_executable(const struct object *object)
{
    Elf64_Shdr section;

    return section_find(object, ".note.GNU-stack", &section) &&
           !(section.sh_flags & SHF_EXECINSTR);
}

/* One note: name GNU, type 5 (properties), one property of 4 bytes: the features it keeps to. */
static bool keeps_to_control_flow(const struct object *object)
{
    static const uint32_t expected[] = {4, 16, 5, 0x554e47 /* GNU */, FEATURE_1_AND, 4};
    uint32_t note[7];
    Elf64_Shdr section;

    if (!section_find(object, ".note.gnu.property", &section) ||
        section.sh_size < sizeof note || section.sh_offset + sizeof note > object->size) {
        return false;
    }
    memcpy(note, object->bytes + section.sh_offset, sizeof note);
    return memcmp(note, expected, sizeof expected) == 0 &&
           (note[6] & IBT_AND_SHSTK) == IBT_AND_SHSTK;
}

/* In stage5_asm/span.S; here without its arguments, as it is not called. */
void stage5_draw_segments(void);

/* ISO C has no cast from a function to what its bytes are. */
static bool begins_with_endbr64(void (*function)(void))
{
    static const unsigned char endbr64[] = {0xf3, 0x0f, 0x1e, 0xfa};
    const unsigned char *code;

    memcpy(&code, &function, sizeof code);
    return memcmp(code, endbr64, sizeof endbr64) == 0;
}

/* The readers must see what is missing: a note renamed, a bit set that must not be. */
static void test_readers(struct object *object)
{
    static const char *const names[] = {".note.GNU-stack", ".note.gnu.property"};
    static struct object broken;
    Elf64_Shdr section;

    for (int i = 0; i < 2; i++) {
        broken = *object;
        for (size_t k = 0; k + sizeof ".note.gnu.property" < broken.size; k++) {
            if (memcmp(broken.bytes + k, names[i], strlen(names[i])) == 0) {
                broken.bytes[k] = '_';
            }
        }
        check(i == 0 ? !stack_not_executable(&broken) : !keeps_to_control_flow(&broken),
              "an object without the note is found out", "%s", names[i]);
    }
    broken = *object;
    if (section_find(&broken, ".note.gnu.property", &section)) {
        broken.bytes[section.sh_offset + 24] &= 1; /* the features' lowest byte: no SHSTK */
    }
    check(!keeps_to_control_flow(&broken), "an object without the shadow stack is found out",
          "not found out");
}

/* Beside the program, where make puts the objects; or in the folder that TEXMAP_BUILD names. */
static bool objects_find(glob_t *found)
{
    const char *build = getenv("TEXMAP_BUILD");
    char pattern[PATH_MAX + 32], self[PATH_MAX];
    const ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);

    if (!build && length > 0) {
        self[length] = '\0';
        *strrchr(self, '/') = '\0';
        build = self;
    }
    snprintf(pattern, sizeof pattern, "%s/stage5_asm/span*.o", build ? build : "build");
    return glob(pattern, 0, NULL, found) == 0;
}

void test_asm_object(void)
{
    static struct object object;
    glob_t found;

    if (!check(objects_find(&found), "stage 5's assembly is there as an object file",
               "no stage5_asm/span*.o beside the program or in TEXMAP_BUILD")) {
        return;
    }
    for (size_t i = 0; i < found.gl_pathc; i++) {
        const char *path = found.gl_pathv[i];
        if (!check(object_read(&object, path), "the object file is ELF", "%s", path)) {
            continue;
        }
        check(stack_not_executable(&object), "the stack need not be executable", "%s", path);
        check(keeps_to_control_flow(&object), "control-flow enforcement may be on", "%s", path);
    }
    check(begins_with_endbr64(stage5_draw_segments),
          "an indirect call may land on stage5_draw_segments",
          "it does not begin with endbr64");
    test_readers(&object);
    globfree(&found);
}

#endif
