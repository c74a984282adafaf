/* In the page's module a segment's length is chosen while it runs: SEGMENT_LENGTH names this. */
extern int chosen_segment_length; /* pixels from one divide to the next, 1 to 4096 */
