W339 = the normals of the { $type } { $id } lie in its own plane
    .label = light along the triangle: it is dark or black
    .help = a normal stands across the triangle: are two numbers swapped?
W339-interleaved = normals of the { $type } { $id } lie in its own plane, unless each corner has its normal behind it
    .label = the three normals stand here
    .help = the three corners come first, the three normals behind them
    .fix = put the corners first
