### Co říká zpg, česky.
###
### Zprávy jsou tytéž jako v en.ftl. Názvy z jazyka scén jsou v terms.cs.ftl.

## Výčty a co stojí kolem nálezů

list-or = { $first } nebo { $last }
list-and = { $first } a { $last }
list-clauses = { $first } a { $last }

here = zde
guess = (odhad)
or-fix = nebo { $title }
fix-on-line = na řádku { $line }: { $title }

error = chyba
warning = varování
note = poznámka
style = styl

tally-clean = Vše je v pořádku!
tally-incomplete = V { $files ->
    [one] { $files } souboru
   *[other] { $files } souborech
} se nic nenašlo; co nešlo přečíst, se nezkontrolovalo.
tally-errors = { $count ->
    [one] { $count } chyba
    [few] { $count } chyby
   *[other] { $count } chyb
}
tally-warnings = { $count } varování
tally-notes = { $count ->
    [one] { $count } poznámka
    [few] { $count } poznámky
   *[other] { $count } poznámek
}
tally-style = { $count ->
    [one] { $count } připomínka ke stylu
    [few] { $count } připomínky ke stylu
   *[other] { $count } připomínek ke stylu
}
tally-found = Nalezeno: { $findings } ({ $files ->
    [one] { $files } soubor
    [few] { $files } soubory
   *[other] { $files } souborů
}){ $fixable ->
    [0] { $unsafe ->
        [0] .
       *[other] ; `zpg check --fix --unsafe-fixes` opraví { $unsafe }.
    }
   *[other] ; `zpg check --fix` opraví { $fixable }{ $unsafe ->
        [0] .
       *[other] , s `--unsafe-fixes` ještě { $unsafe }.
    }
}
fixed = Opraveno: { $count ->
    [one] { $count } nález
    [few] { $count } nálezy
   *[other] { $count } nálezů
} ({ $files ->
    [one] { $files } soubor
    [few] { $files } soubory
   *[other] { $files } souborů
}).
change = { $place }: { $old } → { $new }
change-nothing = nic
allowed = Povoleno: { $count ->
    [one] { $count } nález
    [few] { $count } nálezy
   *[other] { $count } nálezů
} ({ $files ->
    [one] { $files } soubor
    [few] { $files } soubory
   *[other] { $files } souborů
}).
would-fix = Opravilo by se: { $count ->
    [one] { $count } nález
    [few] { $count } nálezy
   *[other] { $count } nálezů
} ({ $files ->
    [one] { $files } soubor
    [few] { $files } soubory
   *[other] { $files } souborů
}).
diff-left = `--diff --unsafe-fixes` ukáže navíc { $count ->
    [one] { $count } odhad
    [few] { $count } odhady
   *[other] { $count } odhadů
}.
diff-no-safe-fixes = Bezpečně tu nelze opravit nic; `zpg check` ukáže { $count ->
    [one] { $count } nález
    [few] { $count } nálezy
   *[other] { $count } nálezů
}{ $unsafe ->
    [0] .
    [one] {" "}a `--diff --unsafe-fixes` { $unsafe } odhad.
    [few] {" "}a `--diff --unsafe-fixes` { $unsafe } odhady.
   *[other] {" "}a `--diff --unsafe-fixes` { $unsafe } odhadů.
}
diff-no-fixes = Opravit tu nelze nic; `zpg check` ukáže { $count ->
    [one] { $count } nález
    [few] { $count } nálezy
   *[other] { $count } nálezů
}.
folded = { $count ->
    [one] ještě { $count } takový nález, na místě { $places }
    [few] ještě { $count } takové nálezy, na místech { $places }
   *[other] ještě { $count } takových nálezů, na místech { $places }
}
folded-row = { $count ->
    [one] ještě { $count } záznam jako ten na řádku { $line }, na místě { $places }
    [few] ještě { $count } záznamy jako ten na řádku { $line }, na místech { $places }
   *[other] ještě { $count } záznamů jako ten na řádku { $line }, na místech { $places }
}
folded-cut = { $count ->
    [one] ještě { $count } takový nález, na místě { $places }
    [few] ještě { $count } takové nálezy, první na místech { $places }
   *[other] ještě { $count } takových nálezů, první na místech { $places }
}

## Společné věty

fix-write = napsat { $number }
fix-write-all = { $count ->
    [one] napsat { $number } v tomto záznamu
    [few] napsat { $number } ve všech { $count } záznamech
   *[other] napsat { $number } ve všech { $count } záznamech
}
fix-space = chybí-li mezera, napsat { $number }
fix-defined = napsat { $number } v definici výše
fix-both-ways = je-li to totéž číslo v obou směrech, napsat { $number }
fix-czech-key = na české klávesnici je { $key } na klávese { $digit }: napsat { $number }
fix-type = napsat `{ $number }` ({ $type })
fix-types = vyměnit typy obou záznamů: napsat zde `{ $number }` ({ $type })
fix-lost-type = za ID napsat typ `{ $number }` ({ $type })
fix-comment = dát to do komentáře
fix-doubled = vynechat čísla, která jsou tu dvakrát
fix-tinted = jsou-li tato tři čísla koeficienty propustnosti pro červenou, zelenou a modrou, napsat { $number }
fix-normal = je-li { $text } normála roviny a zbytek její bod, napsat { $number }
fix-moved = napsat elipsoid { $number } a jeho střed jako posunutí
fix-quad = jsou-li to čtyři vrcholy, napsat dva trojúhelníky a jejich sjednocení
fix-flat-profile = vynechat třetí číslo každého bodu, které je 0
fix-colour-each = napsat barvu { $text } { $count }×, pro každý bod jednou
fix-colour-apart = napsat typ `{ $number }` ({ $type }) a barvu { $text } jako samostatný záznam
fix-operation = nad ostatní záznamy s jeho ID napsat `{ $text }`: { $first } a { $last } nejsou nikde použity
fix-difference = minus zde není doplněk; průnik s doplňkem objektu { $id } je rozdíl: napsat { $number }
fix-union = napsat nad něj `{ $text }`, sjednocení dvou objektů, které nejsou nikde použity
fix-switch-on = { $count ->
    [one] vyjmout záznam { $id } z komentáře
   *[other] vyjmout z komentářů záznam { $id } i to, co potřebuje
}
fix-first-operand = místo { $id } napsat { $number }, první operand záznamu v komentáři
fix-without-light = vynechat sjednocení { $other } a místo něj napsat { $number }
fix-switch-off = obejít se bez { $id }: dát do komentáře i { $type } { $other } a místo { $other } napsat { $number }
fix-again = odstranit ho: tentýž záznam je už o řádek výš
fix-joined = napsat { $number } a indexu lomu { $id } dát ID { $other }, aby jedna vlastnost měla obojí
fix-decimal-comma = je-li v { $text } desetinná čárka, napsat { $number }
lack = zapsaná čísla jsou možná { $have }; pak chybí { $missing } ({ $parameter })
lack-any = parametry jsou po řadě `{ $missing }`; nelze poznat, které chybí
lost = možná chybí jeho definice; `--unsafe-fixes` odhady nepoužije
no-part = bodové světlo svítí samo; není částí tělesa
choose = několik odhadů je stejně dobrých: vyberte z nich, `--unsafe-fixes` nepoužije žádný
undecided = `--unsafe-fixes` tento odhad nepoužije: jen vy víte, zda je správný
refused = `--unsafe-fixes` tu žádný odhad nepoužije: nálezů by po něm nebylo méně
switched-off = záznam { $id } je v komentáři na řádku { $line }
behind-sign = řádek { $behind } není v komentáři: komentář před ním končí jeho prvním znakem `#`
comment-ends = komentář končí druhým znakem `#`; co stojí za ním, se čte jako čísla
assignment-ids = ID je ID objektu, T jeho textury nebo barvy a O jeho optické vlastnosti; 0 znamená žádnou
smaller-matrix = matice 3 × 3 o devíti číslech se píše šestnácti: za každým řádkem 0 a poslední řádek 0 0 0 1
alpha = alfa k barvě nepatří: kolik světla objekt propustí, je `kt` jeho optických vlastností (`-201`)
quaternion = tato čtyři čísla jsou možná kvaternion; neotáčí kolem osy x, y ani z, takže se tu píše jako matice rotace (`-4`)
fix-lamp = napsat intenzitu 1 a barvu jako samostatný záznam
fix-lamp-place = napsat intenzitu 1 a polohu jako samostatný záznam
fix-angle-last = zorný úhel patří na konec: napsat { $number }
fix-apart = napsat { $text } jako samostatný záznam ({ $type })
fix-copy = napsat to jako kopii objektu { $text } a její posunutí
fix-apart-both = napsat { $text } jako dva samostatné záznamy: posunutí a barvu
fix-sign-apart = napsat `{ $number }` a { $text } jako samostatný záznam ({ $type })
fix-sign-apart-both = napsat `{ $number }` a { $text } jako dva samostatné záznamy: posunutí a barvu
fix-flat = napsat obdélník v rovině z = 0 a co jej dostane na místo: { $records }
fix-origin = vynechat polohu { $text }: tento tvar je v počátku
fix-inline = { $count ->
    [one] napsat barvu { $text } jako samostatný záznam
   *[other] napsat barvy { $text } jako samostatné záznamy
}
fix-equation = má-li to být { $type } dvou objektů, napsat { $number }
fix-block = napsat to jako záznamy
fix-block-angle = napsat to jako záznamy; `angle` v POV-Ray je úhel na šířku, na výšku je to při 4:3 { $number }
fix-block-plane = pokud jde o `plane` z POV-Ray, jejíž d má opačné znaménko, napsat to jako záznamy
fix-clauses = napsat záznam pro tvar a po jednom pro každou jeho vlastnost
fix-clauses-some = napsat záznam pro tvar a po jednom pro každou vlastnost, pro kterou záznam existuje; z ostatních se stane komentář
fix-properties = napsat každou vlastnost a každou transformaci jako samostatný záznam
fix-properties-some = napsat každou vlastnost a každou transformaci jako samostatný záznam; z toho, co žádný záznam neříká, se stane komentář
fix-colour-id = { $count ->
    [one] napsat ID této barvy, { $text }
   *[other] napsat ID těchto barev, { $text }
}
fix-cylinder = napsat { $text } ({ $type })
fix-point = je-li { $text } bod, na který se má kamera dívat, napsat { $number }: směr je tento bod minus poloha kamery
fix-look-at = je-li { $text } bod, na který se má kamera dívat, napsat směr { $way } (tento bod minus poloha kamery) a vektor „nahoru“ { $number }
fix-parts = napsat to jako několik záznamů po dvou objektech ({ $type })
fix-angle = napsat na konec úhel { $number }
fix-lost-number = chybí-li { $name }, napsat na jeho místo { $number }
fix-labelled = vynechat slova
fix-labelled-point = vynechat slova a bod, na který se má kamera dívat, napsat jako směr: tento bod minus poloha kamery
fix-part = je-li { $text } { $parameter }, napsat { $number }
fix-turns = napsat pro každou osu jedno otočení, nejdřív kolem x
fix-quaternion = je-li to kvaternion { $order }, napsat { $number }: úhel ve stupních a osu
fix-up = napsat vektor „nahoru“ { $number }
fix-lay = položit podlahu kolmo k ose y: napsat { $number }
fix-normal-sign = změnit znaménko normály: napsat { $number }
fix-per-cent = jsou-li čísla v { $text } procenta, napsat { $number }
leading-zero = číslo v záznamu začíná nulou: s { $number } toto hlášení zmizí
fix-ten-times-smaller = má-li být odečítaný objekt desetkrát menší, napsat { $number } pro { $id }
fix-place-and-view = prohodit polohu a směr: napsat { $number }
fix-sign-of-place = změnit znaménko { $axis } kamery: napsat { $number }
fix-view-and-up = prohodit oba vektory: směr pohledu { $number }, nahoru { $up }
fix-free-id = dát záznamu ID { $number }
fix-chain = { $count ->
    [one] dát této operaci nové ID { $number } a ve všech záznamech níže psát { $number } místo { $text }
    [few] dát každé z těchto { $count } operací vlastní ID ({ $number }), které místo { $text } použije ta další
   *[other] dát každé z těchto { $count } operací vlastní ID ({ $number }), které místo { $text } použije ta další
}
fix-named-id = dát záznamu volné ID: napsat { $number }
fix-own-id = dát záznamu ID { $number } a napsat ho i v přiřazení ({ $text })
defined-here = { $id } je definováno zde
declared-here = { $id } je deklarováno zde

## Text

E001 = { $text } tu nic neznamená
    .label = zde má být číslo
    .help = odstraňte to, nebo to dejte do komentáře: `# … #`
E001-sign = { E001 }
    .label = minus stojí těsně před svým číslem
    .help = připojte ho k číslu za ním, nebo ho odstraňte

E001-slashes = { $text } zde komentář nezačíná: komentář stojí mezi dvěma znaky `#`
    .label = { $count ->
        [one] co následuje, čte se jako čísla
       *[other] co následuje, čte se jako čísla (řádků: { $count })
    }
    .fix = { $count ->
        [one] dát to do komentáře
       *[other] dát do komentářů všechny tyto řádky
    }

E002 = tento komentář není ukončen
    .label = čte se, jako by končil na konci řádku
    .help = komentář začíná znakem `#` a musí jím i končit
    .fix = ukončit komentář na konci řádku
    .fix-inner = vynechat `#` uvnitř komentáře

E003 = { $text } není číslo
    .label = chybně zapsané číslo
    .help = čísla se píší takto: `3`, `-0.5`, `1.5e-3`; minus je obyčejné `-` z klávesnice
    .fix = { fix-write }
E003-degrees = { E003 }
    .label = { E003.label }
    .help = úhel je samotné číslo ve stupních; znak stupně se nepíše
    .fix = { fix-write }
E003-decimal-comma = { $text } má desetinnou čárku
    .label = čteno jako { $number }
    .help = čísla se píší s desetinnou tečkou
    .fix = { fix-write }
E003-decimal-commas = { $text } a další čísla na tomto řádku mají desetinnou čárku (celkem { $count })
    .label = čteno jako { $number }
    .help = { E003-decimal-comma.help }
    .fix = napsat ve všech desetinnou tečku
E003-dashes = { $text } není číslo: místo minusu je tu typografická pomlčka (v souboru { $count }×)
    .label = pomlčka, ne minus
    .help = při kopírování z PDF se z minusu stává pomlčka; zde musí být `-`
    .fix = napsat `-` na všech místech ({ $count }×)
E003-colour = barva se zapisuje třemi čísly, ne { $text }
    .label = v lineárním RGB: { $number }
    .help = čísla jsou lineární, od 0 do 1; šestnáctkový zápis a jména barev z CSS jsou v sRGB
    .fix = { fix-write }
E003-material = { $text } je jméno materiálu; zde mají být jeho čísla
    .label = například { $number }
    .help = `-201 kd ks kt` říká, jaká část světla se rozptýlí, zrcadlově odrazí a projde; `-203` je index lomu
    .fix = { fix-write }
E003-glued = { $text } není jedno číslo, ale několik
    .label = zde chybí mezera: { $number }
    .help = s mezerou má záznam správný počet čísel
    .fix = { fix-write }

E004 = { $text } je příliš velké
    .label = tak velké číslo se do dvojité přesnosti nevejde
    .help = největší je asi `1.8e308`
E004-count = { $text } bodů se nevejde do žádného souboru
    .label = N, počet bodů profilu
E004-id = ID { $text } je příliš velké
    .label = největší možné ID je 2147483647

E005 = { $text } nemůže být ID
    .label = zde má být ID
    .help = na začátku záznamu je jeho ID, celé číslo od 1 do 2147483647
E005-negative = { E005 }
    .label = ID musí být kladné
    .help = { E005.help }
E005-lost = { $type }: chybí ID
    .label = toto je typ, { $number }; před něj patří ID
    .help = { $type } se zapisuje { $header }
E005-name = { $type }: chybí ID, kterým záznam začíná
    .label = jméno typu { $number } není ID
    .help = { E005-lost.help }
E005-swapped = { $text } tu nemůže být ID: ID a typ jsou prohozeny
    .label = renderovací záznam začíná { $number }
    .help = renderovací záznam má vždy ID 1 a typ 9999
    .fix = { fix-write }
E005-drawn = renderovací záznam začíná { $number }; ID toho, co se vykreslí, stojí až za tím
    .label = typ stojí za tímto ID
    .help = { E005-swapped.help }
E005-exchanged = ID a typ jsou prohozené: { $text } je typ, { $number } ID
    .label = { E005.label }
    .help = záznam začíná svým ID a typ stojí za ním
    .fix = { fix-write }

E006 = za ID { $text } chybí typ
    .label = za tímto ID má být typ záznamu
    .help = záznam má tvar `ID TYP parametry…`
E006-word = { $text } není typ záznamu
    .label = zde má být číslo typu
    .help = { $name ->
        [none] číslo typu zjistíte příkazem `zpg explain` se jménem, například `zpg explain koule`
       *[other] číslo tohoto typu a jak se zapisuje, zjistíte příkazem `zpg explain { $name }`
    }
E006-lost = záznamu chybí typ: jeho čísla odpovídají typu { $number } ({ $type })
    .label = za tímto ID chybí typ

E007 = typ záznamu { $text } neexistuje
    .label = neznámý typ
E007-proposal = { E007 }
    .label = { E007.label }
    .help = tyto parametry odpovídají typu { $number } ({ $type })
    .fix = { fix-type }
E007-sign = v čísle typu chybí minus: { $number } je { $type }
    .label = čísla za ním odpovídají typu { $number }
E007-minus = { $kinds ->
    [one] v čísle typu chybí minus, v souboru { $count }×: má být { $number } ({ $type })
   *[many] v číslech typů chybí minus, v souboru { $count }×; zde má být { $number } ({ $type })
}
    .label = zde chybí minus
    .help = typy operací, vlastností, světel a kamer jsou záporné; při kopírování z PDF se minus může ztratit
    .fix = doplnit minus ve všech těchto záznamech (celkem { $count })

E008 = příliš málo čísel: { $type } má mít { $fewer ->
    [none] {""}
   *[other] { $fewer } nebo{" "}
}{ $wanted ->
    [one] { $wanted } číslo
    [few] { $wanted } čísla
   *[other] { $wanted } čísel
}, { $got ->
    [0] není zde žádné
    [one] je zde jen { $got }
    [few] jsou zde { $got }
   *[other] je jich zde { $got }
}
    .label = { $off ->
        [one] { $off } číslo chybí
        [few] { $off } čísla chybí
       *[other] { $off } čísel chybí
    }
    .help = { $type-capital }: { $header }
E008-points = { E008 }
    .label = N je { $says }, ale { $points ->
        [one] následuje { $points } bod
        [few] následují { $points } body
       *[other] následuje { $points } bodů
    }
    .help = { E008.help }
    .fix = { fix-write }
E008-row = { E008 }
    .label = tento řádek jich má méně než ostatní
    .help = { E008.help }
    .begin = { $type } začíná zde
E008-sign = { E008 }
    .label = typu chybí znaménko
    .help = { $meant-capital }: { $header }; se znaménkem je záznam správně
    .fix = { fix-write }
E008-count = { $type }: chybí počet bodů
    .label = za typem chybí N
    .help = { E008.help }
E008-file = { $type }: chybí jméno souboru
    .label = za typem chybí jméno souboru
    .help = { E008.help }

E009 = příliš mnoho čísel: { $type } má mít { $fewer ->
    [none] {""}
   *[other] { $fewer } nebo{" "}
}{ $wanted ->
    [one] { $wanted } číslo
    [few] { $wanted } čísla
   *[other] { $wanted } čísel
}, { $got ->
    [one] je zde { $got }
    [few] jsou zde { $got }
   *[other] je jich zde { $got }
}
    .label = { $off ->
        [one] { $off } číslo navíc
        [few] { $off } čísla navíc
       *[other] { $off } čísel navíc
    }
    .help = { $type-capital }: { $header }
E009-points = { E009 }
    .label = N je { $says }, ale { $points ->
        [one] následuje { $points } bod
        [few] následují { $points } body
       *[other] následuje { $points } bodů
    }
    .help = { E009.help }
    .fix = { fix-write }
E009-space = { E009 }
    .label = tři souřadnice pro každý bod
    .help = bod profilu je x y, vzdálenost od osy a výška: { $header }
E009-row = { E009 }
    .label = tento řádek jich má více než ostatní
    .help = { E009.help }
    .begin = { $type } začíná zde
E009-file = { $type }: za jménem souboru stojí něco navíc
    .label = toto je navíc
    .help = { E009.help }

E010 = { $text } není celé číslo
    .label = { $parameter } musí být celé číslo, zapsané bez tečky
    .fix = { fix-write }
E010-reference = { E010 }
    .label = zde má být celé číslo: ID { $parameter-gen }
    .fix = { fix-write }

E011 = { $text } není jméno souboru
    .label = zde má být { $parameter }
    .help = jméno souboru je jedno slovo, nebo text ve dvojitých uvozovkách

E012 = slovo { $text } tu nic neznamená
    .label = zde má být číslo
    .help = je-li to komentář, patří mezi dva znaky `#`
E012-axis = osa { $text } se zapisuje číslem
    .label = 1 je x, 2 je y, 3 je z
E012-axis-first = { E012-axis }
    .label = { E012-axis.label }
    .help = nejdřív se píše úhel, pak osa
E012-parameter = slovo { $text } stojí na místě čísla
    .label = zde má být číslo
    .help = záznam se píše { $header }
E012-angle = rotaci chybí úhel: { $text } je její osa
    .label = před osou má být úhel
    .help = záznam se píše { $header }; osa je 1 pro x, 2 pro y, 3 pro z
E012-file-name = jméno souboru { $text } je víc než jedno slovo
    .label = zde má být jedno slovo
    .help = jméno souboru s mezerami, čárkami nebo závorkami patří do uvozovek
    .fix = { fix-write }

E013 = { $text } bodů je více, než lze zpracovat
    .label = N, počet bodů; { $got ->
        [one] následuje { $got } číslo
        [few] následují { $got } čísla
       *[other] následuje { $got } čísel
    }

E014 = soubor nevypadá jako scéna: { $lines ->
        [one] jeho jediný řádek nezačíná číslem
       *[other] číslem začíná { $numbers } z { $lines } řádků
    }
    .label = tento řádek číslem nezačíná
    .help = scénu tvoří záznamy `ID TYP PARAMETR…` a `# komentáře #`; číslem začíná aspoň polovina jejích řádků
    .comments = jsou-li ostatní řádky komentáře, dejte každý mezi dva znaky `#`
E014-numbers = soubor nevypadá jako scéna: { $all ->
        [one] jeho jediné číslo není v žádném záznamu
       *[other] v záznamech leží { $numbers } z { $all } čísel
    }
    .label = toto není záznam
    .help = scénu tvoří záznamy `ID TYP PARAMETR…`; aspoň polovina jejích čísel leží v záznamech, které lze přečíst nebo v nichž je jediná malá chyba
E014-known = { $kind ->
        [picture] obrázek { $name }
        [recording] zvuková nahrávka { $name }
        [film] film { $name }
        [archive] archiv { $name }
        [document] dokument { $name }
        [program] program { $name }
        [font] písmo { $name }
        [model] 3D model { $name }
        [database] databáze { $name }
       *[file] soubor { $name }
    } není scéna
E014-binary = binární data nejsou scéna
E014-pov-ray = soubor vypadá jako scéna POV-Raye
    .label = řádek v jazyce POV-Raye
    .help = scény POV-Raye číst nelze; `zpg convert SOUBOR --to pov` převádí opačným směrem
E014-long = komentář nebo slovo v souboru má 256 MiB nebo více
    .label = začíná zde
    .help = komentář se ukončuje znakem `#`
E014-json = JSON není scéna
E014-scene-json = soubor je scéna zapsaná v JSON
    .help = přečte se, když jméno souboru končí na .json; na záznamy ji převede `zpg convert SOUBOR.json --to zpg`

E015 = { $why }

W314 = { $type } si bere poslední čísla z řádku, který by sám byl záznamem
    .label = vzato ze začátku tohoto řádku
    .begin = záznam začíná zde
    .note = řádek by sám byl záznam { $line }
    .help = chybí-li nad ním číslo, doplňte ho: { $header }
W314-row = { $type } má mít { $wanted ->
    [one] { $wanted } číslo
    [few] { $wanted } čísla
   *[other] { $wanted } čísel
}, { $got ->
    [one] je zde jen { $got }
    [few] jsou zde { $got }
   *[other] je jich zde { $got }
}: chybí řádek { $off ->
    [one] { $off } čísla
   *[other] { $off } čísel
} a místo něj se čte další řádek
    .label = { W314.label }
    .begin = { W314.begin }
    .note = { W314.note }
    .help = je-li ten řádek záznam, doplňte řádek čísel nad něj: { $header }

N601 = soubor není platné UTF-8; čte se jako Windows-1250
    .label = první bajt, který není UTF-8
    .help = uložte soubor v UTF-8
N604 = soubor je v UTF-16; v něm se čte i zapisuje
    .label = začátek souboru
N604-incomplete = soubor je v UTF-16 a některý znak v něm není úplný; soubor se nepřepíše
    .label = začátek souboru
    .help = uložte soubor v UTF-8

N605 = čísla za záznamem ({ $type }) lze číst dvěma způsoby
    .label = čte se jako součást záznamu
    .help = mohou to být i další záznamy; ty patří na vlastní řádky

## ID

lost-id-used-here = { $lost } se používá zde a není nikde definováno
lost-id-may-be-this = možná má { $lost } definovat tento záznam
put-lost-id-in-front = doplnit na začátek záznamu `{ $lost }`
write-lost-id = napsat `{ $lost }`

E101 = { $id } není definováno
    .label = žádný záznam v souboru toto ID nemá
E101-copied = { E101 }
    .label = { E101.label }
    .help = { $other-id } je definováno dvakrát: druhá definice patří spíš k { $id }
E101-hidden = { E101 }
    .label = { E101.label }
    .help = ID { $id } je definováno uvnitř komentáře, který začíná na řádku { $line }
E101-switched-off = { E101 }
    .label = mimo komentáře nemá toto ID žádný záznam
E101-missing = { E101 }: možná chybí jeho definice
    .label = tento záznam potřebuje definici { $id }
    .help = nad tento záznam napište záznam, který { $id } definuje
E101-missing-colour = { E101 }: možná chybí definice této barvy
    .label = { E101.label }
    .help = nad tento záznam napište barvu, třeba `{ $id } -701 1 1 1`
E101-missing-lamp = { E101 }: možná chybí bodové světlo `{ $id } -402`
    .label = tento záznam mění něco, co není definováno
    .help = nad tento záznam napište bodové světlo, třeba `{ $id } -402 1`
E101-missing-operation = { $id } není objekt: možná chybí záznam objektu { $id }
    .label = žádný záznam nad tímto není objekt s tímto ID
E101-missing-shape = { $id } není objekt: možná chybí záznam tělesa { $id }
    .label = žádný záznam nad tímto není objekt s tímto ID
    .help = záznam tělesa napište nad všechny ostatní, které začínají { $id }
E101-missing-union = { E101 }: možná chybí jeho definice
    .label = { E101.label }
E101-no-id = { $number } není ID
    .label = zde má být ID některého záznamu

E102 = ID { $id } už je definováno
    .label = toto by byla druhá definice ({ $type })
    .help = dejte tomuto záznamu vlastní ID
    .first = poprvé je definováno zde
E102-render = renderovací záznam už ve scéně je
    .label = scéna má jen jeden, s ID 1
    .help = jeden z nich odstraňte
    .first = první renderovací záznam je zde
E102-property = { E102 }
    .label = { E102.label }
    .first = { E102.first }, jako vlastnost, která zatím není ničemu přiřazena
    .help = má-li to být vlastnost tohoto záznamu, přesuňte ji za něj
    .fix = { $count ->
        [one] přesunout ten záznam pod tuto definici
        [few] přesunout ty { $count } záznamy pod tuto definici
       *[other] přesunout těch { $count } záznamů pod tuto definici
    }
E102-scenes = v souboru jsou zřejmě dvě scény: { $count ->
    [one] { $count } ID je definováno
    [few] { $count } ID jsou definována
   *[other] { $count } ID je definováno
} dvakrát
    .label = zde začíná druhá scéna
    .help = dejte záznamům jedné scény jiná ID a ponechte jeden renderovací záznam
    .first = toto ID má i první scéna
    .fix = přičíst { $number } ke všem ID druhé scény a vykreslit obě

E102-renders = v souboru jsou zřejmě dvě scény: obě mají renderovací záznam
    .label = zde začíná druhá scéna
    .help = scéna má jediný renderovací záznam; sjednocení objektů obou scén vykreslí všechno
    .render = tímto záznamem první scéna končí
    .fix = vykreslit objekty obou

E103 = { $id } je { $kind }; má to být { $kinds }
    .label = zde má být: { $parameter }
E103-changed = { $id } je { $kind }; záznam „{ $type }“ patří jen k ID tohoto druhu: { $kinds }
    .label = zde má být { $kinds }

E104 = { $id } je použito ve své vlastní definici
    .label = { $parameter } musí být něco jiného

E105 = renderovací záznam musí mít ID 1
    .label = toto ID
    .fix = napsat `1`
E105-swapped = ID renderovacího záznamu a to, co se vykresluje, jsou prohozené
    .label = renderovací záznam má ID 1 a vykresluje se { $id }
E105-again = renderovací záznam musí mít ID 1, ale je jich tu víc
    .label = toto ID
    .help = ponechte jeden z nich
E105-other = ID 1 je vyhrazeno renderovacímu záznamu; { $type } musí mít jiné
    .label = toto ID
    .help = použijte jiné ID
E105-objects = { E105-other }
    .label = { E105-other.label }
    .help = { E105-other.help }
    .fix = napsat { $number } zde i všude, kde se toto ID používá

E106 = chybí renderovací záznam
    .label = není určeno, co se má vykreslit
    .help = přidejte `1 9999 OBJEKT POZADÍ`: místo OBJEKT napište ID toho, co se má vykreslit, místo POZADÍ ID barvy, nebo 0 pro černou
    .fix = přidat { $text }

E107 = { $id } se používá dříve, než je definováno
    .label = ještě není definováno
    .help = scéna se čte shora dolů: co se používá, patří výš
    .later = definováno zde
    .fix = přesunout definici { $id } výš
    .fix-down = přesunout tento záznam za definici { $id }
E107-changed = { $id } se mění dříve, než je definováno
    .label = ještě není definováno
    .help = scéna se čte shora dolů: tento záznam patří až za definici
    .later = definováno zde
    .fix = přesunout záznam za definici
E107-cycle = { $id } a { $own } závisí na sobě navzájem: žádné z nich nelze definovat jako první
    .label = { $own } závisí na { $id }, a to zase na { $own }
    .help = definice tvoří kruh, { $own } → { $members }; jeden z těchto odkazů musí vést jinam
    .later = definováno zde

E108 = { $id } je deklarováno, ale ještě není definováno
    .label = nejprve je třeba definovat: { $parameter }
E108-changed = { E108 }
    .label = { $type }: zatím není co změnit

## Hodnoty

E201 = { $type }: { $parameter } musí být větší než nula
    .label = `{ $name }` je { $text }
    .fix = { fix-write }
    .fix-swap = prohodit výšku a poloměr

E202 = { $type }: { $lower } je větší než { $upper }{ $others ->
    [0] {""}
   *[other] ; totéž ještě { $others }×
}
    .label = dolní mez
    .other = horní mez
    .fix = prohodit je
    .fix-order = napsat nejdřív všechny dolní meze, pak všechny horní
    .fix-number = napsat { $number } místo { $text }
    .fix-size = je-li { $text } velikost, napsat { $number }
    .fix-centre = je-li { $centre } střed a { $text } velikost, napsat { $number }
    .fix-half = je-li { $centre } střed a { $text } polovina velikosti, napsat { $number }

E203 = { $type }: { $vector } je nulový vektor
    .label = nemá žádný směr

E204 = { $type } je singulární: nemá inverzi
    .label = zobrazí celý prostor do roviny, na přímku nebo do bodu
E204-rounded = { $type } nemá ve dvojité přesnosti inverzi
    .label = matice je téměř singulární, nebo má příliš velká či příliš malá čísla
E204-row = poslední řádek matice rotace musí být 0 0 0 1
    .label = tento řádek
E204-transposed = { E204-row }
    .label = { E204-row.label }
    .help = matice tu násobí sloupcové vektory: posunutí je v jejím posledním sloupci
    .fix = transponovat matici
E204-scale = { $type }: { $parameter } nesmí být nula
    .label = `{ $name }` je { $text }
E204-product = { $type }: transformace objektu { $id } pak nemají inverzi
    .label = čísla jsou příliš velká nebo příliš malá pro dvojitou přesnost

E205 = { $type }: osa musí být 1 (x), 2 (y) nebo 3 (z)
    .label = `{ $name }` je { $text }
E205-turned = { E205 }
    .label = { E205.label }
    .help = nejdřív se píše úhel, potom osa
    .fix = prohodit je

E206 = { $type }: { $parameter } musí být mezi { $low } a { $high }
    .label = `{ $name }` je { $text }
E206-between = { $type }: { $parameter } musí být mezi { $low } a { $high } (bez krajních hodnot)
    .label = `{ $name }` je { $text }
    .fix = { fix-write }
E206-least = { $type }: { $parameter } musí být aspoň { $low }
    .label = `{ $name }` je { $text }
E206-count = { $type }: počet bodů profilu nemůže být { $value }
    .label = N, počet bodů profilu, musí být aspoň 2

E207 = směr pohledu kamery a vektor „nahoru“ jsou rovnoběžné
    .label = společně mají určit, kde je v obrázku nahoře
    .help = vektor „nahoru“ bývá `0 1 0`; míří-li kamera přímo dolů, zvolte `0 0 -1`, přímo nahoru `0 0 1`
E207-down = { E207 }
    .label = { E207.label }
    .help = kamera míří přímo dolů: vektor „nahoru“ je pak `0 0 -1`; nebo má být směr jiný, třeba `0 -1 -3`
E207-up = { E207 }
    .label = { E207.label }
    .help = kamera míří přímo nahoru: vektor „nahoru“ je pak `0 0 1`; nebo má být směr jiný, třeba `0 1 -3`
E207-projection = pro část obrázku nemá tato matice projekce žádný paprsek
    .label = není tam vidět nic, co je před kamerou
    .help = kamera hledí proti ose z: poslední řádek perspektivy bývá 0 0 -1 0

E207-nearly = směr pohledu kamery a vektor „nahoru“ jsou až na zaokrouhlení rovnoběžné
    .label = { E207.label }
    .help = { E207.help }

E208 = { $type }: { $parameter } nesmí být záporná
    .label = `{ $name }` je { $text }
    .help = bod profilu se píše `x y`: x je vzdálenost od osy, y výška
    .fix-turned = prohodit x a y každého bodu
    .fix = { fix-write }

E209 = obrázek musí ležet ve složce scény
    .label = tato cesta vede jinam
    .help = zkopírujte obrázek ke scéně nebo do složky vedle ní a uveďte cestu k němu od scény
E209-backslash = cesta se ve scéně píše s `/`
    .label = zde je `\`
E209-link = { E209 }
    .label = toto je odkaz, který vede jinam

E210 = obrázek nelze přečíst: { $why }
    .label = tento soubor
    .help = soubor se hledá ve složce scény
E210-format = obrázek není ani PNG, ani JPEG
    .label = { E210.label }
# Je tam a je známého formátu, ale nelze ho přečíst: bez nápovědy.
E210-content = { E210 }
    .label = { E210.label }

## Varování

no-inside = nemá vnitřek: nic z toho se nezobrazí a nic to neodřízne
nothing-drawn = nic z toho se nezobrazí

## Poznámky a styl

S504 = { $count ->
    [one] { $entries } se zde povoluje, ale nevyskytuje se
   *[other] { $entries } se zde povolují, ale nevyskytují se
}
    .label = není co povolit
    .fix = { $count ->
        [one] odstranit to
       *[other] odstranit je
    }
S504-unknown = tomuto komentáři zpg nerozumí
    .help = záměr označte komentářem `# zpg: allow(W307) #` s kódem nebo názvem nálezu
S504-empty = položka tohoto komentáře je prázdná
    .help = záměr označte komentářem `# zpg: allow(W307) #` s kódem nebo názvem nálezu
S504-no-code = { $count ->
    [one] kód { $text } neexistuje
   *[other] kódy { $text } neexistují
}
    .help = všechny kódy vypíše `zpg explain`
S504-error = { $count ->
    [one] chybu { $code } povolit nelze
   *[other] chyby povolit nelze: { $code }
}
