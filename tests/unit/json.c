#include "tests/unit/json.h"

#include <string.h>
#include "tests/unit/check.h"

/* Is a JSON value there? Returns what follows it, or NULL. */
static const char *json_value(const char *text);

static const char *skip_space(const char *text)
{
    return text + strspn(text, " \n");
}

static const char *json_string(const char *text)
{
    const char *end = *text == '"' ? strpbrk(text + 1, "\"\\\n") : NULL;

    while (end && *end == '\\') { /* \u and four digits */
        end = end[1] == 'u' && strspn(end + 2, "0123456789abcdef") >= 4
                  ? strpbrk(end + 6, "\"\\\n")
                  : NULL;
    }
    return end && *end == '"' ? end + 1 : NULL;
}

/* -?(0|[1-9][0-9]*)(.[0-9]+)?(e[+-]?[0-9]+)? */
static const char *json_number(const char *text)
{
    const char *digits = text + (*text == '-'), *end = digits + strspn(digits, "0123456789");

    if (end == digits || (*digits == '0' && end != digits + 1)) {
        return NULL;
    }
    for (const char *mark = ".e"; *mark; mark++) {
        if (*end == *mark) {
            digits = end + 1;
            digits += *mark == 'e' && (*digits == '-' || *digits == '+');
            end = digits + strspn(digits, "0123456789");
            if (end == digits) {
                return NULL;
            }
        }
    }
    return end;
}

/* What stands between brackets: values, or a key and a value each, with commas between. */
static const char *json_members(const char *text, bool keys, char close)
{
    text = skip_space(text + 1);
    for (bool first = true; text && (*text != close || !first); first = false) {
        if (keys) {
            text = json_string(text);
            if (!text || *text++ != ':') {
                return NULL;
            }
        }
        text = json_value(text);
        if (!text || *text == close || *text != ',') {
            break;
        }
        text = skip_space(text + 1);
    }
    return text && *text == close ? text + 1 : NULL;
}

static const char *json_value(const char *text)
{
    text = skip_space(text);
    const char *end = strncmp(text, "null", 4) == 0 ? text + 4
                      : *text == '{'                ? json_members(text, true, '}')
                      : *text == '['                ? json_members(text, false, ']')
                      : *text == '"'                ? json_string(text)
                                                    : json_number(text);
    return end ? skip_space(end) : NULL;
}

bool json_valid(const char *text)
{
    const char *end = json_value(text);
    return end && *end == '\0';
}

void test_json(void)
{
    const char *const good[] = {"{}", "[]", "[1,-2.5,3e-07,null]",
                                "{\"a\":[{\"b\":0}],\"c\":\"d\"}\n",
                                "\"\\u000a\\u003c\""};
    const char *const bad[] = {"",      "{",      "[1,]", "[,1]", "[1 2]", "{\"a\"}",
                               "{a:1}", "[nan]",  "[01]", "[1.]", "[-]",   "{\"a\":}",
                               "[1]]",  "[inf]",  "[1e]", "\"",   "[nul]", "{\"a\":1,}",
                               "\"\\n\"", "\"\\u12\""};

    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        check(json_valid(good[i]), "the checker takes JSON", "not %s", good[i]);
    }
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        check(!json_valid(bad[i]), "the checker refuses what is no JSON", "not %s", bad[i]);
    }
}
