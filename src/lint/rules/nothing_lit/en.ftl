W330 = all that the camera { $id } sees is black: no light falls on it
    .label = light from here does not reach what the camera sees
    .camera = the camera
    .note = in a picture of { $width } by { $height } pixels
    .help = move the light to where the camera is, or add ambient light (-401)
