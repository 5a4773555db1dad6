/* SPDX-License-Identifier: GPL-3.0-or-later */
/* near_words.h - which particles are near a block of eight: for each word of eight particles, a
 * byte per particle with a bit for each lane of the block that it is near to. They are found in any
 * order, by way of a hash table, and then taken out of it in ascending order. */
#ifndef FW_NEAR_WORDS_H
#define FW_NEAR_WORDS_H

#include <stdbool.h>
#include <stdint.h>

typedef struct fw_near_word {
    int word; /* number of particle / 8 */
    uint64_t bytes;
} fw_near_word;

/* Zeroed memory is an empty one. */
typedef struct fw_near_words {
    int *word;       /* the table; -1: free */
    uint64_t *bytes; /* of each */
    int *used;       /* places in the table, `count` of them */
    int count, capacity;
    int last;    /* place of the word that was written last */
    bool failed; /* without memory */
    /* Those of the block that was last taken out, and of the one before; a count of -1: of none. */
    fw_near_word *taken, *before;
    int taken_count, before_count;
} fw_near_words;

/* Where that word is or may be put: there is always a free place. Knuth's multiplicative hash (The
 * Art of Computer Programming 3, 6.4): 2^32 over the golden ratio. */
static inline int fw_near_words_place(const fw_near_words *words, int word)
{
    const unsigned last = (unsigned)words->capacity - 1;
    unsigned at = (unsigned)word * 0x9e3779b1u >> 8 & last;
    while (words->word[at] >= 0 && words->word[at] != word) at = (at + 1) & last;
    return (int)at;
}

void fw_near_words_release(fw_near_words *words);
/* Doubles the table, or begins one; false without memory. What was taken is forgotten. */
bool fw_near_words_grow(fw_near_words *words);

/* Shell's sort, with the gaps of Ciura (2001): some dozen words, mostly in order. */
static inline void fw_near_words_sort(fw_near_word *list, int count)
{
    static const int gaps[] = {57, 23, 10, 4, 1};
    for (int g = 0; g < 5; ++g) {
        const int gap = gaps[g];
        for (int k = gap; k < count; ++k) {
            const fw_near_word word = list[k];
            int place = k;
            for (; place >= gap && list[place - gap].word > word.word; place -= gap)
                list[place] = list[place - gap];
            list[place] = word;
        }
    }
}

/* Empties the table into words->taken, whose words ascend. */
static inline void fw_near_words_take(fw_near_words *words)
{
    fw_near_word *list = words->before;
    words->before = words->taken;
    words->before_count = words->taken_count;
    words->taken = list;
    words->taken_count = words->count;
    for (int k = 0; k < words->count; ++k) {
        const int used = words->used[k];
        list[k] = (fw_near_word){words->word[used], words->bytes[used]};
        words->word[used] = -1;
        words->bytes[used] = 0;
    }
    words->count = 0;
    fw_near_words_sort(list, words->taken_count);
}

/* Forgets what was taken: the next block does not follow any other. */
static inline void fw_near_words_forget(fw_near_words *words)
{
    words->taken_count = -1;
}

/* Does this block see the same as the one before, every word one further? */
static inline bool fw_near_words_repeat(const fw_near_words *words)
{
    const fw_near_word *taken = words->taken, *before = words->before;
    if (words->taken_count != words->before_count) return false;
    for (int k = 0; k < words->taken_count; ++k)
        if (taken[k].word != before[k].word + 1 || taken[k].bytes != before[k].bytes) return false;
    return true;
}

#endif
