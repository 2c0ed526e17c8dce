### Co říká zpg, česky.
###
### Zprávy jsou tytéž jako v en.ftl. Názvy z jazyka scén jsou v terms.cs.ftl; název na místě $type má
### i další tvary, které jsou tam uvedeny: $type-gen (2. pád), $type-acc (4. pád).

## Výčty a co stojí kolem nálezů

list-or = { $first } nebo { $last }
list-and = { $first } a { $last }
list-clauses = { $first } a { $last }

here = zde
guess = (odhad)

error = chyba
warning = varování
note = poznámka
style = styl

tally-clean = Vše je v pořádku!
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
       *[other] ; opraví `zpg check --fix --unsafe-fixes`: { $unsafe }.
    }
   *[other] ; opraví `zpg check --fix`: { $fixable }{ $unsafe ->
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
would-fix = K opravě: { $count ->
    [one] { $count } nález
    [few] { $count } nálezy
   *[other] { $count } nálezů
} ({ $files ->
    [one] { $files } soubor
    [few] { $files } soubory
   *[other] { $files } souborů
}).
folded = { $count ->
    [one] ještě { $count } takový nález, na { $places }
    [few] ještě { $count } takové nálezy, na { $places }
   *[other] ještě { $count } takových nálezů, na { $places }
}
folded-cut = ještě { $count } takových nálezů, první na { $places }

## Společné věty

fix-write = napsat { $number }
defined-here = { $id } je definováno zde
declared-here = { $id } je ohlášeno zde

## Text

E001 = { $text } tu nic neznamená
    .label = zde mělo být číslo
    .help = odstraňte to, nebo dejte do komentáře: `# … #`

E002 = tento komentář není ukončen
    .label = má se za to, že končí s řádkem
    .help = ukončete komentář znakem `#`
    .fix = ukončit komentář na konci řádku

E003 = { $text } není číslo
    .label = chybně zapsané číslo
    .help = čísla vypadají takto: `3`, `-0.5`, `1.5e-3`
    .fix = { fix-write }
E003-decimal-comma = { $text } má desetinnou čárku
    .label = čteno jako { $number }
    .help = čísla se píší s desetinnou tečkou
    .fix = { fix-write }
E003-glued = { $text } není jedno číslo, ale několik
    .label = zde chybí mezera: { $number }
    .help = záznam pak má tolik čísel, kolik má mít
    .fix = { fix-write }

E004 = { $text } je příliš velké
    .label = tak velké číslo se do dvojité přesnosti nevejde
    .help = největší je asi 1.8e308
E004-count = tolik bodů, { $text }, se nevejde do žádného souboru
    .label = N, počet bodů profilu
E004-id = ID { $text } je příliš velké
    .label = ID jsou nejvýše 2147483647

E005 = { $text } nemůže být ID
    .label = zde mělo být ID
    .help = záznam začíná svým ID, celým číslem od 1 do 2147483647
E005-negative = { E005 }
    .label = ID jsou kladná
    .help = { E005.help }
E005-lost = { $type }: chybí ID
    .label = toto je typ, { $number }; před něj patří ID
    .help = { $type } se zapisuje { $header }
E005-swapped = { $text } tu nemůže být ID: ID a typ jsou prohozené
    .label = renderovací záznam začíná { $number }
    .help = renderovací záznam má vždy ID 1 a typ 9999
    .fix = { fix-write }

E006 = za ID { $text } chybí typ
    .label = za tímto ID měl být typ záznamu
    .help = záznam má tvar `ID TYP parametry…`
E006-word = { $text } není typ záznamu
    .label = zde mělo být číslo typu
    .help = číslo typu prozradí `zpg explain` s jeho anglickým názvem, například `zpg explain sphere`

E007 = typ záznamu { $text } neexistuje
    .label = neznámý typ
E007-proposal = { E007 }
    .label = { E007.label }
    .help = tyto parametry odpovídají typu { $number }, { $type }
    .fix = napsat `{ $number }` ({ $type })

E008 = příliš málo čísel: { $type } má mít { $fewer ->
    [none] {""}
   *[other] { $fewer } nebo{" "}
}{ $wanted ->
    [one] { $wanted } číslo
    [few] { $wanted } čísla
   *[other] { $wanted } čísel
}, zde je jich { $got }
    .label = { $off ->
        [one] { $off } číslo chybí
        [few] { $off } čísla chybí
       *[other] { $off } čísel chybí
    }
    .help = { $type-capital }: { $header }
E008-row = { E008 }
    .label = tento řádek jich má méně než ostatní
    .help = { E008.help }
    .begin = { $type } začíná zde
E008-count = { $type }: chybí počet bodů
    .label = za typem chybí N
    .help = { E008.help }

E009 = příliš mnoho čísel: { $type } má mít { $fewer ->
    [none] {""}
   *[other] { $fewer } nebo{" "}
}{ $wanted ->
    [one] { $wanted } číslo
    [few] { $wanted } čísla
   *[other] { $wanted } čísel
}, zde je jich { $got }
    .label = { $off ->
        [one] { $off } číslo navíc
        [few] { $off } čísla navíc
       *[other] { $off } čísel navíc
    }
    .help = { $type-capital }: { $header }
E009-row = { E009 }
    .label = tento řádek jich má více než ostatní
    .help = { E009.help }
    .begin = { $type } začíná zde

E010 = { $text } není celé číslo
    .label = { $parameter } musí být celé číslo, psané bez tečky
    .fix = { fix-write }

E011 = { $text } není jméno souboru
    .label = zde má být { $parameter }
    .help = jméno souboru je jedno slovo, nebo stojí ve dvojitých uvozovkách

E012 = slovo { $text } tu nic neznamená
    .label = zde mělo být číslo
    .help = komentáře stojí mezi dvěma `#`
E012-file-name = jméno souboru { $text } obsahuje mezery
    .label = zde mělo být jedno slovo
    .help = jméno souboru s mezerami patří do uvozovek
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
    .label = tento řádek jím nezačíná
    .help = scénu tvoří záznamy `ID TYP PARAMETR…` a `# komentáře #`; číslem začíná aspoň polovina jejích řádků
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
    .help = scény POV-Raye číst nelze; `zpg convert FILE --to pov` překládá opačným směrem
E014-json = JSON není scéna
E014-scene-json = soubor je scéna zapsaná v JSON
    .help = `zpg convert FILE --to zpg` ji zapíše jako záznamy

W314 = { $type } si bere poslední čísla z řádku, který by byl sám celým záznamem
    .label = vzato ze začátku tohoto řádku
    .begin = záznam začíná zde
    .note = sám o sobě by řádek zněl { $line }
    .help = chybí-li výše číslo, doplňte je: { $header }

N601 = soubor není platné UTF-8; čte se jako Windows-1250
    .label = první bajt, který není UTF-8
    .help = uložte soubor v UTF-8
N604 = soubor je v UTF-16; tak se čte i zapisuje
    .label = začátek souboru
N604-incomplete = soubor je v UTF-16 a něco v něm není znak; nezapisuje se do něj
    .label = začátek souboru
    .help = uložte soubor v UTF-8

## ID

lost-id-used-here = { $lost } se používá zde a není nikde definováno
lost-id-may-be-this = možná je to záznam, který má definovat { $lost }
put-lost-id-in-front = napsat před to `{ $lost }`
write-lost-id = napsat `{ $lost }`

E101 = { $id } není definováno
    .label = toto ID v souboru nic nemá
E101-no-id = { $number } není ID
    .label = zde mělo být nějaké ID

E102 = ID { $id } už je definováno
    .label = toto by byla druhá definice ({ $type })
    .help = dejte mu vlastní ID
    .first = poprvé je definováno zde
E102-render = renderovací záznam už ve scéně je
    .label = scéna má jediný, s ID 1
    .help = jeden z nich odstraňte
    .first = { E102.first }
E102-property = { E102 }
    .label = { E102.label }
    .first = { E102.first }, jako vlastnost, kterou zatím nic nemá
    .help = má-li to být vlastnost tohoto záznamu, přesuňte ji za něj

E103 = { $id } je { $kind }
    .label = zde má být ID tohoto druhu: { $kinds }
E103-changed = na { $id } nelze použít záznam „{ $type }“: je to { $kind }
    .label = zde má být { $kinds }

E104 = { $id } je použito ve své vlastní definici
    .label = { $parameter } musí být něco jiného

E105 = renderovací záznam musí mít ID 1
    .label = toto ID
    .fix = napsat `1`
E105-other = ID 1 je vyhrazeno renderovacímu záznamu; { $type } je mít nemůže
    .label = toto ID
    .help = použijte jiné ID

E106 = chybí renderovací záznam
    .label = nic neříká, co se má zobrazit
    .help = přidejte `1 9999 OBJEKT POZADÍ` s ID objektu a s ID barvy (nebo 0)

E107 = { $id } se používá dříve, než je definováno
    .label = ještě není definováno
    .help = přesuňte definici výš: scéna se čte shora dolů
    .later = definováno zde

E108 = { $id } je ohlášeno, ale ještě není definováno
    .label = nejprve je třeba definovat: { $parameter }
E108-changed = { E108 }
    .label = { $type } potřebuje něco, co by šlo změnit

## Hodnoty

E201 = { $type }: { $parameter } musí být větší než nula
    .label = `{ $name }` je { $text }

E202 = { $type }: { $lower } je větší než { $upper }{ $others ->
    [0] {""}
   *[other] , a ještě { $others }×
}
    .label = dolní mez
    .other = horní mez
    .fix = prohodit je

E203 = { $type }: { $vector } je nulový vektor
    .label = nemá žádný směr

E204 = { $type } je singulární: nemá inverzi
    .label = zobrazuje prostor na něco plochého
E204-rounded = { $type } nemá v dvojité přesnosti inverzi
    .label = matice je příliš blízko takové, která zobrazuje prostor na něco plochého, nebo má příliš velká či malá čísla
E204-row = poslední řádek matice rotace musí být 0 0 0 1
    .label = tento řádek
E204-scale = { $type }: { $parameter } nesmí být nula
    .label = `{ $name }` je { $text }
E204-product = { $type }: transformace objektu { $id } pak nemají inverzi
    .label = čísla jsou příliš velká nebo příliš malá pro dvojitou přesnost

E205 = { $type }: osa musí být 1 pro x, 2 pro y, nebo 3 pro z
    .label = `{ $name }` je { $text }
E205-turned = { E205 }
    .label = { E205.label }
    .help = nejdřív se píše úhel, potom osa
    .fix = prohodit je

E206 = { $type }: { $parameter } musí být mezi { $low } a { $high }
    .label = `{ $name }` je { $text }
E206-between = { $type }: { $parameter } musí být mezi { $low } a { $high } (kromě krajních hodnot)
    .label = `{ $name }` je { $text }
E206-least = { $type }: { $parameter } musí být aspoň { $low }
    .label = `{ $name }` je { $text }
E206-count = { $type }: počet bodů profilu nemůže být { $value }
    .label = N, počet bodů profilu, musí být aspoň 2

E207 = směr pohledu kamery a vektor „nahoru“ (up-vector) jsou rovnoběžné
    .label = mají určovat svislou rovinu obrazu
E207-projection = pro část obrázku nemá tato projekční matice žádný paprsek
    .label = není tam vidět nic, co je před kamerou
    .help = kamera hledí proti ose z: poslední řádek perspektivy bývá 0 0 -1 0

E207-nearly = směr pohledu kamery a vektor „nahoru“ (up-vector) jsou až na zaokrouhlení rovnoběžné
    .label = { E207.label }

E208 = { $type }: { $parameter } nesmí být záporná
    .label = `{ $name }` je { $text }

E209 = obrázek musí ležet ve složce scény
    .label = tato cesta vede jinam
    .help = zkopírujte obrázek ke scéně a uveďte jej bez složky
E209-link = { E209 }
    .label = toto je odkaz, který vede jinam

E210 = obrázek nelze přečíst
    .label = { $why }
    .help = soubor se hledá ve složce scény
E210-format = { E210 }
    .label = není to obrázek PNG ani JPEG
    .help = { E210.help }

## Varování

W301 = složky barvy leží mezi 0 a 1; zde je { $parts }
    .label = použije se tak, jak je
    .note = složka větší než 1 činí povrch jasnějším než světlo, které na něj dopadá, záporná světlo ubírá; světlo má kromě barvy i intenzitu
    .bytes = vypadá to na čísla od 0 do 255
    .divide = vydělit číslem 255
    .fix = napsat nejbližší přípustnou hodnotu
W301-point = složky barvy leží mezi 0 a 1; v bodě profilu { $point } je { $parts }{ $others ->
    [0] {""}
    [one] {" "}a mimo rozsah je ještě { $others } barva
    [few] {" "}a mimo rozsah jsou ještě { $others } barvy
   *[other] {" "}a mimo rozsah je ještě { $others } barev
}
    .label = { W301.label }
    .note = { W301.note }
    .bytes = { W301.bytes }
    .divide = { W301.divide }
    .fix = { W301.fix }

sum-in-red = kd + ks + kt = { $red } v červené
sum-in-green = kd + ks + kt = { $green } v zelené
sum-in-blue = kd + ks + kt = { $blue } v modré

W302 = tento povrch vydává více světla, než dostává: kd + ks + kt = { $sum }
    .label = více než 1
    .help = tyto tři části se dělí o dopadající světlo; jejich součet má být nejvýše 1
W302-red = { W302 } v červené
    .label = { W302.label }
    .help = { W302.help }
W302-green = { W302 } v zelené
    .label = { W302.label }
    .help = { W302.help }
W302-blue = { W302 } v modré
    .label = { W302.label }
    .help = { W302.help }

W303 = tato matice není rotace: { $deeds }
    .label = použije se tak, jak je
    .help = k záměrnému zvětšení nebo zrcadlení použijte typ -3
    .fix = napsat nejbližší rotaci
    .mirrors = zrcadlí
    .scales = její sloupce mají délky { $x }, { $y } a { $z }, ne 1
    .skews = její sloupce nejsou na sebe kolmé
    .rounded = její čísla se liší o více než 1e-6

W304 = matice kvadriky { $id } není symetrická: { $first } je { $first-number }, ale { $mirror } je { $mirror-number }{ $more ->
    [0] {""}
    [one] {" "}a liší se ještě { $more } dvojice
    [few] {" "}a liší se ještě { $more } dvojice
   *[other] {" "}a liší se ještě { $more } dvojic
}
    .label = { $first }
    .other = { $mirror }
    .note = záleží jen na součtu obou: kvadrika se kreslí, jako by obě čísla byla jejich průměr
    .fix = { $pairs ->
        [one] napsat na obě místa jejich průměr
        [few] napsat průměr ve všech { $pairs } dvojicích
       *[other] napsat průměr ve všech { $pairs } dvojicích
    }

no-inside = nemá vnitřek: nic z toho se nezobrazí a nic to neodřízne
nothing-drawn = nic z toho se nezobrazí

W305 = { $type } { $id } má nulový objem
    .note = { no-inside }
W305-box = { $type } { $id } má nulový objem: { $pairs }
    .label = { $lower }
    .other = { $upper }
    .note = { no-inside }
W305-rectangle = { $type } { $id } má nulovou plochu: { $pairs }
    .label = { $lower }
    .other = { $upper }
    .note = { nothing-drawn }
W305-triangle = { $type } { $id } má nulovou plochu: jeho tři vrcholy leží na přímce
    .label = vrcholy
    .note = { nothing-drawn }
W305-triangle-nearly = { $type } { $id } má až na zaokrouhlení čísel nulovou plochu: jeho tři vrcholy leží na přímce
    .label = vrcholy
    .note = co se z něj zobrazí, závisí na tomto zaokrouhlení
W305-cone = { $type } { $id } má nulový objem: jeho výška je 0
    .label = h
    .note = { no-inside }
W305-point = { $type } { $id } má nulový objem: vyhovuje jí jediný bod
    .label = xᵀQx není nikde menší než 0
    .note = { no-inside }
W305-line = { $type } { $id } má nulový objem: vyhovují jí jen body přímky
    .label = { W305-point.label }
    .note = { no-inside }
W305-plane = { $type } { $id } má nulový objem: vyhovují jí jen body roviny
    .label = { W305-point.label }
    .note = { no-inside }
W305-axis = { $type } { $id } má nulový objem: všechny body jeho profilu leží na ose
    .label = profil
    .note = { no-inside }
W305-profile = { $type } { $id } má nulový objem: jeho profil neohraničuje žádnou plochu
    .label = profil
    .note = { no-inside }

W305-profile-nearly = { $type } { $id } má až na zaokrouhlení čísel nulový objem: jeho profil neohraničuje žádnou plochu
    .label = profil
    .note = co se z něj zobrazí, závisí na tomto zaokrouhlení

W306 = kvadrice { $id } nevyhovuje žádný bod
    .label = tato matice
    .note = xᵀQx je všude větší než 0: objekt je prázdný, nic z něj se nezobrazí, a odečtením od jiného se nic nezmění
W306-ball = { W306 }
    .label = { W306.label }
    .note = { W306.note }
    .help = koule s poloměrem r má na místech m11 až m33 čísla 1 a m44 je -r²
    .fix = obrátit znaménko m44
W306-full = kvadrice { $id } vyhovuje každý bod
    .label = { W306.label }
    .note = xᵀQx není nikde větší než 0: objekt vyplňuje celý prostor, nemá povrch, který by šlo zobrazit, a z čeho se odečte, z toho nic nezbude
W306-zero = kvadrice { $id } vyhovuje každý bod
    .label = { W306.label }
    .note = xᵀQx je všude 0: objekt vyplňuje celý prostor a nemá povrch, který by šlo zobrazit

W307 = ve sjednocení { $id } se překrývají { $one } { $one-id } a { $two } { $two-id } s různými optickými vlastnostmi: bod ({ $x }, { $y }, { $z }) leží v obou
    .label = co leží v obou, patří prvnímu operandu
    .first = { $one }
    .second = { $two }
    .note = kde je první operand, není povrch druhého vidět: obrázek závisí na pořadí operandů
    .help = odečtěte jedno od druhého, nebo zapište překryv jako část s vlastními vlastnostmi
    .fix = zapsat jako (A ∩ B) ∪ (A − B) ∪ (B − A)

W307-open = sjednocení { $id }: { $one } { $one-id } a { $two } { $two-id } se překrývají, vypadají různě a jsou rozříznuté: v bodě ({ $x }, { $y }, { $z }) vede řez oběma
    .label = { W307.label }
    .first = { W307.first }
    .second = { W307.second }
    .note = kde jsou oba, vypadá řez jako první z nich: obrázek závisí na pořadí operandů
    .help = { W307.help }
    .fix = { W307.fix }

W308 = průnik { $id } nevypadá všude stejně: { $first } { $first-id } a { $second } { $second-id } se liší ({ $aspects ->
    [texture] barva
    [optics] optická vlastnost
    [index] index lomu
    [texture-optics] barva a optická vlastnost
    [texture-index] barva a index lomu
    [optics-index] optická vlastnost a index lomu
   *[all] barva, optická vlastnost a index lomu
})
    .label = výsledku { $id } není nic přiřazeno
    .note = každá část povrchu má vlastnosti toho operandu, ze kterého pochází
    .help = má-li celý povrch vypadat stejně, přiřaďte vlastnosti výsledku: `{ $id } -299 TEXTURA OPTIKA`
    .fix = dát { $id } tytéž vlastnosti, jaké má { $source }

W309 = { $change } objektu { $id } přichází pozdě: { $taker } { $taker-id } už má jeho dřívější podobu{ $more ->
    [0] {""}
    [one] ; totéž platí o další { $more } změně
    [few] ; totéž platí o dalších { $more } změnách
   *[other] ; totéž platí o dalších { $more } změnách
}
    .label = na výsledku se to už neprojeví
    .taken = zde se { $id } použije
    .note = operace bere operandy v té podobě, jakou v daném místě mají
    .help = přesuňte tento záznam před ten, který { $id } používá, nebo změňte { $taker-id } místo { $id }
W309-property = { $type } { $id } se mění pozdě: { $taker-id } už má dřívější podobu{ $more ->
    [0] {""}
    [one] ; totéž platí o další { $more } změně
    [few] ; totéž platí o dalších { $more } změnách
   *[other] ; totéž platí o dalších { $more } změnách
}
    .label = { W309.label }
    .taken = { W309.taken }
    .note = vlastnosti a barvy se přiřazují v té podobě, jakou v daném místě mají
    .help = přesuňte tento záznam před ten, který { $id } používá

W310 = { $type } { $id } se nikde nepoužije
    .label = nic z toho, co se zobrazí, to nepotřebuje
    .help = přiřaďte to pomocí `ID -299 TEXTURA OPTIKA`, nebo záznam odstraňte
W310-object = { $type } { $id } není součástí toho, co se zobrazí
    .label = nic z toho, co se zobrazí, objekt nepoužívá
    .help = připojte objekt ke scéně sjednocením, nebo jej odstraňte
W310-placeholder = { $id } je ohlášeno, ale není ani definováno, ani použito
    .label = ohlášení bez definice
    .help = definujte objekt níže, nebo ohlášení odstraňte

W311 = obalový kvádr objektu { $id } je příliš malý: ({ $x }, { $y }, { $z }) je bod povrchu objektu
    .label = tento kvádr má obsahovat celý objekt
    .note = obrázek zůstane stejný, ale program, který kvádru věří, vynechá vše, co leží vně
    .fix = zvětšit jej
W311-sphere = obalová koule objektu { $id } je příliš malá: ({ $x }, { $y }, { $z }) je bod povrchu objektu
    .label = tato koule má obsahovat celý objekt
    .note = obrázek zůstane stejný, ale program, který kouli věří, vynechá vše, co leží vně
    .fix = zvětšit ji

W312 = kvádr renderovacího záznamu ořezává scénu: { $type } { $id } z něj přesahuje v bodě ({ $x }, { $y }, { $z })
    .label = co leží mimo tento kvádr, není vidět
    .shape = toto z něj přesahuje
    .note = řez není uzavřený: je vidět dovnitř objektu
    .help = zvětšete kvádr, nebo označte řez za záměrný: `# zpg: allow(W312) #`
W312-outside = nic nebude vidět: celý objekt { $id } leží mimo kvádr renderovacího záznamu, { $axis } má všude { $where ->
        [above] nejméně
       *[below] nejvýše
    } { $reach }
    .label = { $name }, stěna kvádru
    .note = co leží mimo kvádr, není vidět žádným paprskem

W312-part = { $type } { $id } nebude vidět: leží celé mimo kvádr renderovacího záznamu, { $axis } je všude { $where ->
        [above] nejméně
       *[below] nejvýše
    } { $reach }{ $others ->
        [0] {""}
        [one] ; mimo leží ještě { $others } další část
        [few] ; mimo leží ještě { $others } další části
       *[other] ; mimo leží ještě { $others } dalších částí
    }
    .label = { $name }, stěna kvádru
    .shape = toto se nevykreslí
    .note = { W312-outside.note }
    .help = zvětšete kvádr, nebo vynechte, co se nevykreslí

W313 = { $operand } { $operand-id } { $what ->
    [whole] je plocha bez vnitřku: průnik { $id } z ní
   *[part] obsahuje plochu bez vnitřku: průnik { $id } z ní
} ponechá to, co je uvnitř ({ $other } { $other-id })
    .label = tento operand
    .surface = { $shape } { $shape-id } je plocha: nemá vnitřek
    .help = operace jsou určeny tělesům: místo roviny (typ 3) lze použít poloprostor (typ 4), místo obdélníku tenký kvádr
W313-outside = { $operand } { $operand-id } { $what ->
    [whole] je plocha bez vnitřku: rozdíl { $id } z ní
   *[part] obsahuje plochu bez vnitřku: rozdíl { $id } z ní
} ponechá to, co je venku ({ $other } { $other-id })
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
W313-tool = { $operand } { $operand-id } { $what ->
    [whole] je plocha bez vnitřku: jejím
   *[part] obsahuje plochu bez vnitřku: jejím
} odečtením se nic nezmění ({ $other } { $other-id })
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
W313-both = { $operand } { $operand-id } a { $other } { $other-id } jsou plochy bez vnitřku: jejich průnik { $id } je prázdný
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
W313-complement = { $operand } { $operand-id } { $what ->
    [whole] je plocha bez vnitřku: jejím doplňkem { $id } je celý prostor
   *[part] obsahuje plochu bez vnitřku: doplněk { $id } k ní nepřihlíží
}
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }

W315 = tento komentář skrývá { $count ->
    [one] záznam: { $type } { $id }
    [few] { $count } záznamy, první je { $type } { $id }
   *[other] { $count } záznamů, první je { $type } { $id }
}
    .label = zde komentář začíná
    .first = toto by byl záznam
    .end = zde komentář končí
    .help = ukončete komentář znakem `#` na jeho řádku; co už není potřeba, je lépe odstranit

W316 = { $count ->
    [one] je tu { $count } kamera a není vybrána
    [few] jsou tu { $count } kamery a žádná není vybrána
   *[other] je tu { $count } kamer a žádná není vybrána
}: obraz se pořídí poslední z nich, { $id }
    .label = tato se použije
    .unused = { $other } se nepoužije
    .help = jednu lze vybrat pomocí `ID -502 KAMERA`, dvojici pro stereoskopický obraz pomocí `ID -503 LEVÁ PRAVÁ`
    .fix = vybrat { $id }

W318 = tento index lomu nemá žádný vliv: { $object } { $object-id } nepropouští světlo
    .label = všude, kde index platí, je kt 0
    .help = světlo se láme tam, kde se ho část propouští: dejte objektu optickou vlastnost s kt > 0, například `{ $object-id } -201 0 0.1 0.9`
W318-below-one = index lomu je nejméně 1, jako ve vakuu; zde je { $parts }
    .label = méně než 1
    .help = index patří látce samotného objektu; okolí se započítává zvlášť

W319 = { $operation } { $id }: výsledek je prázdný, { $one } { $one-id } a { $two } { $two-id } se neprotínají, { $axis } ≤ { $end } a { $axis } ≥ { $begin }
    .label = nic nezbude
    .one = { $one }
    .two = { $two }
    .note = nic z něj se nevykreslí
W319-balls = { $operation } { $id }: výsledek je prázdný, { $one } { $one-id } a { $two } { $two-id } se neprotínají, středy jsou od sebe { $between }, součet poloměrů je { $radii }
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }
W319-parts = { $operation } { $id }: výsledek je prázdný, { $one } { $one-id } leží mimo všechny části druhého operandu: { $two } { $two-id }
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }
W319-both = { $operation } { $id }: výsledek je prázdný, { $one } { $one-id }: nic není zároveň uvnitř i venku
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }
W319-beyond = { $operation } { $id }: výsledek je prázdný, { $one } { $one-id } leží zcela mimo druhý operand: { $two } { $two-id }
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }
W319-within = { $operation } { $id }: výsledek je prázdný, { $one } { $one-id } leží uvnitř odečítaného objektu: { $two } { $two-id }
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }
W319-same = { $operation } { $id }: výsledek je prázdný, { $one } { $one-id } a odečítaný objekt jsou totéž: { $two } { $two-id }
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }
W319-itself = { $operation } { $id }: výsledek je prázdný, { $one } { $one-id } se odečítá od sebe
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }

W320 = { $type } { $id }: profil protíná sám sebe poblíž x = { $x }, y = { $y }
    .label = { $one ->
        [start] kruh, který uzavírá první bod
        [end] kruh, který uzavírá poslední bod
       *[piece] úsek z bodu { $one-from } do bodu { $one-to }
    }
    .other = { $two ->
        [start] kruh, který uzavírá první bod
        [end] kruh, který uzavírá poslední bod
       *[piece] úsek z bodu { $two-from } do bodu { $two-to }
    }
    .note = co profil obíhá dvakrát, je podle pravidla sudá–lichá venku: uvnitř je dutina
    .help = nejsou dva body profilu v opačném pořadí?
W320-torus = torus { $id } prochází sám sebou: trubka (r = { $tube }) je širší než prstenec (R = { $ring })
    .label = r, poloměr trubky
    .ring = R, od osy do středu trubky
    .note = místo kolem osy, kde se trubka překrývá sama se sebou, už k tělesu nepatří: uvnitř je dutina
    .fix = prohodit R a r

W321 = { $operation } { $id }: { W321.the-tool } končí přesně na povrchu, který má { W321.the-other }: mají společnou stěnu kolem ({ $x }, { $y }, { $z })
    .label = { $tool-face ->
        [side] stěna { $tool-name }
        [boundary] hraniční rovina
        [base] podstava
        [mantle] plášť
        [disc] kruh, který uzavírá tento konec
        [piece] tento úsek
       *[all] povrch
    }
    .other = { $other-face ->
        [side] stěna { $other-name }
        [boundary] hraniční rovina
        [base] podstava
        [mantle] plášť
        [disc] kruh, který uzavírá tento konec
        [piece] tento úsek
       *[all] povrch
    }
    .operation = { $operation }
    .note = zda tam zbude stěna nulové tloušťky, záleží na zaokrouhlení
    .help = protáhněte nástroj o kousek za stěnu, kterou prořezává
    .fix = protáhnout nástroj o kousek dál
    .the-tool = { $tool-copy ->
        [none] { $tool } { $tool-id }{ $tool-in ->
            [none] {""}
           *[other] {" "}v { $tool-in }
        }
       *[other] { $tool } { $tool-id } v kopii { $tool-copy }
    }
    .the-other = { $other-copy ->
        [none] { $other } { $other-id }{ $other-in ->
            [none] {""}
           *[other] {" "}v { $other-in }
        }
       *[other] { $other } { $other-id } v kopii { $other-copy }
    }
W321-round = { W321 }
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = { W321.note }
    .help = udělejte tam nástroj o kousek větší než to, co řeže, nebo zapište obojí stejně: o stejných tvarech na jednom místě se rozhoduje přesně
    .fix = { W321.fix }
W321-holes = { $operation } { $id }: { W321.the-tool } řeže až tam, kam { W321.the-other }: mají společnou stěnu kolem ({ $x }, { $y }, { $z })
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = zda mezi nimi zbude stěna nulové tloušťky, záleží na zaokrouhlení
    .help = nechte jeden z nich zasahovat o kousek do druhého
    .fix = { W321.fix }
W321-touch = { $operation } { $id }: { W321.the-tool } a { W321.the-other } se jen dotýkají: mají společnou stěnu kolem ({ $x }, { $y }, { $z })
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = co tam mají společného, je plocha nulové tloušťky; zda je vidět, záleží na zaokrouhlení

W322 = { $type } { $id } má příliš rozdílné rozměry: { $large } je { $large-size }, { $small } jen { $small-size }
    .label = délky, které se liší více než 1e8krát
    .note = na obojí šestnáct číslic nestačí: průsečíky na malých částech jsou vedle o velkou část jejich rozměru a hrany vyjdou roztřepené
    .help = přibližte rozměry k sobě, nebo přesuňte objekt blíže k počátku
W322-moved = { $type } { $id } má po přesunutí a natažení příliš rozdílné rozměry: { $large } je { $large-size }, { $small } jen { $small-size }
    .label = { W322.label }
    .note = { W322.note }
    .help = { W322.help }
W322-stretched = { $type } { $id } má po přesunutí a natažení příliš rozdílné rozměry: { $large } podél vlastní osy { $large-axis } je { $large-size }, { $small } podél vlastní osy { $small-axis } jen { $small-size }
    .label = { W322.label }
    .note = { W322.note }
    .help = { W322.help }

## Poznámky a styl

N602 = chybí kamera; pohled na scénu se zvolí automaticky
    .help = kamera se zapisuje `ID -501 x y z dx dy dz ux uy uz fovy`

N603 = chybí světlo; od kamery svítí světlo s intenzitou 1
    .help = bodové světlo se zapisuje `ID -402 intenzita` a přesouvá se pomocí `ID -1 x y z`

S501 = `{ $text }` patří do popisu v tabulce; ve scéně se nepíše
    .label = čteno jako mezera
    .fix = { $count ->
        [one] odstranit
       *[other] odstranit všechny na tomto řádku ({ $count })
    }

S502 = samostatný komentář se uvádí záznamem `0`
    .fix = napsat před něj `0`

S503 = { $count ->
    [one] další záznam na tomtéž řádku
    [few] { $count } další záznamy na tomtéž řádku
   *[other] { $count } dalších záznamů na tomtéž řádku
}
    .fix = jeden záznam na řádek

S504 = { $count ->
    [one] { $entries } se zde dovoluje, ale nevyskytuje
   *[other] { $entries } se zde dovolují, ale nevyskytují
}
    .label = není co dovolit
    .fix = { $count ->
        [one] odstranit to
       *[other] odstranit je
    }
S504-unknown = tomuto komentáři zpg nerozumí
    .help = co je v pořádku, se zapisuje `# zpg: allow(W307) #`, s kódy nebo názvy
S504-empty = položka tohoto komentáře je prázdná
    .help = co je v pořádku, se zapisuje `# zpg: allow(W307) #`, s kódy nebo názvy
S504-no-code = { $count ->
    [one] kód { $text } neexistuje
   *[other] kódy { $text } neexistují
}
    .help = všechny kódy vypíše `zpg explain`
S504-error = { $count ->
    [one] chybu { $code } dovolit nelze
   *[other] chyby dovolit nelze: { $code }
}
