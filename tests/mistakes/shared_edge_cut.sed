# common/clip.c: clip: a shared edge is cut once
s/from_inside ? cut(plane, from, to) : cut(plane, to, from)/cut(plane, from, to)/
