W329 = all that is drawn is smaller than a pixel: the camera { $id } sees it { $size } pixels wide and high at most
    .label = seen from here
    .note = in a picture of { $width } by { $height } pixels
    .help = move the camera nearer, make the angle of view smaller, or make the objects larger
