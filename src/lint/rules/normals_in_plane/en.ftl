W339 = the normals of the { $type } { $id } lie in its plane
    .label = with these normals the triangle is dark or black
    .help = a normal is perpendicular to the triangle: are two numbers swapped?
W339-interleaved = normals of the { $type } { $id } lie in its plane; perhaps each corner has its normal right behind it
    .label = the three normals stand here
    .help = the three corners come first, the three normals behind them
    .fix = put the corners first
