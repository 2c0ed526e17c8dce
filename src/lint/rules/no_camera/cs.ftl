N602 = chybí kamera; pohled na scénu se zvolí automaticky
    .help = kamera se zapisuje `ID -501 x y z dx dy dz ux uy uz fovy`
