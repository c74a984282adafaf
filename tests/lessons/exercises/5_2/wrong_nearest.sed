# span.S
# To the nearest, but half of a 65536th to the even one.
s/^        cvttps2dq \\end, \\end/        cvtps2dq \\end, \\end/
