N603 = chybí světlo; přidá se ambientní světlo 0,2 a bodové světlo 0,8 nad kamerou a vlevo od ní
    .help = bodové světlo se zapisuje `ID -402 intenzita` a přesouvá se pomocí `ID -1 x y z`
